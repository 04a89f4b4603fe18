// A directional or spot light fitted to what a scene is about, as the gallery's light.cpp fits them.
import * as THREE from "three";

const SPOT_DISTANCE = 12;
const SPOT_FAR = 4 * SPOT_DISTANCE;

function corners({low, high}) {
    return Array.from({length: 8}, (_, i) => new THREE.Vector3(...low.map((value, axis) => (i >> axis & 1 ? high[axis] : value))));
}

// A camera at eye that looks along direction, with -z up, as the map has it.
function place(camera, eye, direction) {
    camera.up.set(0, 0, -1);
    camera.position.copy(eye);
    camera.lookAt(eye.clone().add(direction));
    camera.updateMatrixWorld();
    return camera;
}

// Where the frustum's edges meet the ground, or end before they do: the deepest receivers that the map can see.
function groundCorners(camera) {
    const found = [];
    for (const [x, y] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
        const from = new THREE.Vector3(x, y, -1).unproject(camera);
        const to = new THREE.Vector3(x, y, 1).unproject(camera);
        if (from.y > 0 && to.y < from.y)
            found.push(from.clone().lerp(to, Math.min(from.y / (from.y - to.y), 1)));
    }
    return found;
}

function rangeOf(focus, camera, distance) {
    const distances = [...corners(focus), ...groundCorners(camera)].map(distance);
    return new THREE.Vector2(Math.min(...distances), Math.max(...distances));
}

function directional(focus, direction) {
    const [low, high] = [new THREE.Vector3(...focus.low), new THREE.Vector3(...focus.high)];
    const reach = low.distanceTo(high) / 2;
    const origin = low.add(high).multiplyScalar(0.5).addScaledVector(direction, -reach);
    const camera = place(new THREE.OrthographicCamera(), origin, direction);
    const seen = new THREE.Box3().setFromPoints(corners(focus).map((point) => point.applyMatrix4(camera.matrixWorldInverse)));
    Object.assign(camera, {left: seen.min.x, right: seen.max.x, bottom: seen.min.y, top: seen.max.y, near: 0, far: 4 * reach});
    camera.updateProjectionMatrix();
    const range = rangeOf(focus, camera, (point) => point.clone().sub(origin).dot(direction));
    return {camera, position: new THREE.Vector4(...origin, 0), direction, range, cone: new THREE.Vector2(0, 0)};
}

function spot(focus, direction) {
    const centre = new THREE.Vector3(...focus.low).add(new THREE.Vector3(...focus.high)).multiplyScalar(0.5);
    const position = centre.addScaledVector(direction, -SPOT_DISTANCE);
    const camera = place(new THREE.PerspectiveCamera(), position, direction);
    const slopes = corners(focus).map((point) => point.applyMatrix4(camera.matrixWorldInverse))
        .map(({x, y, z}) => Math.max(Math.abs(x / z), Math.abs(y / z)));
    const angle = Math.atan(Math.max(...slopes));
    Object.assign(camera, {fov: 2 * angle * 180 / Math.PI, aspect: 1, near: 1, far: SPOT_FAR});
    camera.updateProjectionMatrix();
    const range = rangeOf(focus, camera, (point) => point.distanceTo(position));
    const edge = Math.cos(angle);
    return {camera, position: new THREE.Vector4(...position, 1), direction, range,
            cone: new THREE.Vector2(edge, edge + 0.3 * (1 - edge))};
}

// The way the light travels, for degrees of azimuth around the vertical and of elevation above the horizon.
export function directionOf(azimuth, elevation) {
    const [a, e] = [azimuth, elevation].map(THREE.MathUtils.degToRad);
    return new THREE.Vector3(-Math.sin(a) * Math.cos(e), -Math.sin(e), -Math.cos(a) * Math.cos(e));
}

export function anglesOf([x, y, z]) {
    return {azimuth: THREE.MathUtils.radToDeg(Math.atan2(-x, -z)), elevation: THREE.MathUtils.radToDeg(Math.asin(-y))};
}

// kind: "directional" or "spot". Result: the camera that draws the map, and what the shaders' light block holds.
export function makeLight(kind, focus, direction) {
    const light = kind === "spot" ? spot(focus, direction) : directional(focus, direction);
    light.toLight = new THREE.Matrix4().multiplyMatrices(light.camera.projectionMatrix, light.camera.matrixWorldInverse);
    light.fromLight = light.toLight.clone().invert();
    return light;
}
