// A light fitted to what a scene is about; directional and spot lights as the gallery's light.cpp fits them.
import * as THREE from "three";

const SPOT_DISTANCE = 12;
const SPOT_FAR = 4 * SPOT_DISTANCE;
// How far a point light stands from the middle, in half diagonals of what it is to cover.
const POINT_DISTANCE = 1.1;
// The faces +x, -x, +y, -y, +z, -z of lvsm_cubePoint: where they look, and what is up in their maps.
const FACES = [[[1, 0, 0], [0, -1, 0]], [[-1, 0, 0], [0, -1, 0]], [[0, 1, 0], [0, 0, 1]], [[0, -1, 0], [0, 0, -1]],
               [[0, 0, 1], [0, -1, 0]], [[0, 0, -1], [0, -1, 0]]];

function corners({low, high}) {
    const corner = (i) => low.map((value, axis) => (i >> axis & 1 ? high[axis] : value));
    return Array.from({length: 8}, (_, i) => new THREE.Vector3(...corner(i)));
}

// A camera at eye that looks along direction.
function place(camera, eye, direction, up = [0, 0, -1]) {
    camera.up.set(...up);
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
    const inView = corners(focus).map((point) => point.applyMatrix4(camera.matrixWorldInverse));
    const {min, max} = new THREE.Box3().setFromPoints(inView);
    Object.assign(camera, {left: min.x, right: max.x, bottom: min.y, top: max.y, near: 0, far: 4 * reach});
    camera.updateProjectionMatrix();
    const range = rangeOf(focus, camera, (point) => point.clone().sub(origin).dot(direction));
    return {cameras: [camera], position: new THREE.Vector4(...origin, 0), direction, range, cone: new THREE.Vector2(0, 0)};
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
    return {cameras: [camera], position: new THREE.Vector4(...position, 1), direction, range,
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

// A face is larger than its share of the cube by a margin of texels, which the blur reaches into.
function point(focus, direction, {size, radius}) {
    const box = new THREE.Box3(new THREE.Vector3(...focus.low), new THREE.Vector3(...focus.high));
    const reach = box.min.distanceTo(box.max) / 2;
    const position = box.getCenter(new THREE.Vector3()).addScaledVector(direction, -POINT_DISTANCE * reach);
    position.y = Math.max(position.y, 0.3 * reach);
    const tangent = size / (size - 2 * (radius + 2));
    const farthest = Math.max(...corners(focus).map((corner) => corner.distanceTo(position)));
    const range = new THREE.Vector2(0.5 * box.distanceToPoint(position), 1.3 * farthest);
    const cameras = FACES.map(([along, up]) => {
        const angle = 2 * Math.atan(tangent) * 180 / Math.PI;
        const camera = new THREE.PerspectiveCamera(angle, 1, 0.02 * reach, 100);
        camera.updateProjectionMatrix();
        return place(camera, position, new THREE.Vector3(...along), up);
    });
    // Its cone is all around.
    const cone = new THREE.Vector2(-3, -2);
    return {cameras, position: new THREE.Vector4(...position, 1), direction, range, cone, tangent};
}

const KINDS = {directional, spot, point};

// kind: of KINDS. map: its size, and the radius of its blur. Result: the cameras that draw the map, and what the shaders
// know of the light.
export function makeLight(kind, focus, direction, map) {
    const light = {tangent: 1, ...KINDS[kind](focus, direction, map)};
    const matrices = light.cameras.map(({projectionMatrix, matrixWorldInverse}) =>
        new THREE.Matrix4().multiplyMatrices(projectionMatrix, matrixWorldInverse));
    light.toLight = Array.from({length: 6}, (_, face) => matrices[face] ?? matrices[0]);
    light.fromLight = light.toLight.map((matrix) => matrix.clone().invert());
    return light;
}
