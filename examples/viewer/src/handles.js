// What is dragged over the picture: the divider, the light, and the camera; each by keys as well.
import * as THREE from "three";
import {OrbitControls} from "three/addons/controls/OrbitControls.js";

const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

// Calls move(dx, dy) in pixels while the handle is dragged, and step(x, y) for arrow keys.
function draggable(handle, {move, step}) {
    let last;
    handle.addEventListener("pointerdown", (event) => {
        handle.setPointerCapture(event.pointerId);
        last = [event.clientX, event.clientY];
        event.preventDefault();
        handle.focus();
    });
    handle.addEventListener("pointermove", (event) => {
        if (!handle.hasPointerCapture(event.pointerId))
            return;
        move(event.clientX - last[0], event.clientY - last[1], event);
        last = [event.clientX, event.clientY];
    });
    handle.addEventListener("keydown", (event) => {
        if (!ARROWS[event.key])
            return;
        event.preventDefault();
        step(...ARROWS[event.key]);
    });
}

export function makeDivider(handle, stage, state) {
    const place = (value) => state.set("divider", Math.min(Math.max(value, 0), 1));
    draggable(handle, {
        move: (dx, dy, event) => {
            const {left, width} = stage.getBoundingClientRect();
            place((event.clientX - left) / width);
        },
        step: (x) => place(Number((state.get("divider") + 0.02 * x).toFixed(3))),
    });
    return {
        update: () => {
            const value = state.get("divider");
            handle.style.left = `${100 * value}%`;
            handle.setAttribute("aria-valuenow", Math.round(100 * value));
        },
    };
}

const wrapped = (degrees) => (degrees + 540) % 360 - 180;

export function makeLightHandle(handle, state) {
    const turn = (azimuth, elevation) => {
        state.set("azimuth", Math.round(wrapped(state.get("azimuth") + azimuth)));
        state.set("elevation", Math.round(Math.min(Math.max(state.get("elevation") + elevation, 15), 90)));
    };
    // Small moves add up to whole degrees.
    const rest = [0, 0];
    draggable(handle, {
        move: (dx, dy) => {
            rest[0] += 0.5 * dx;
            rest[1] -= 0.3 * dy;
            const [azimuth, elevation] = rest.map(Math.trunc);
            rest[0] -= azimuth;
            rest[1] -= elevation;
            if (azimuth || elevation)
                turn(azimuth, elevation);
        },
        step: (x, y) => turn(5 * x, 3 * y),
    });
    return {
        update: () => handle.setAttribute("aria-valuetext",
                                          `azimuth ${state.get("azimuth")}, elevation ${state.get("elevation")} degrees`),
    };
}

// The camera turns around what it looks at, by pointer, wheel and keys; where it stands is a setting.
export function makeCamera(canvas, state) {
    const camera = new THREE.PerspectiveCamera(32, 1.5, 0.1, 200);
    const controls = new OrbitControls(camera, canvas);
    controls.enableDamping = false;
    controls.maxDistance = 60;
    controls.minDistance = 0.2;
    const keep = () => state.set("camera", [...camera.position, ...controls.target]);
    controls.addEventListener("end", keep);
    canvas.addEventListener("keydown", (event) => {
        const arrow = ARROWS[event.key];
        const zoom = {"+": 0.9, "=": 0.9, "-": 1 / 0.9}[event.key];
        if (!arrow && !zoom)
            return;
        event.preventDefault();
        const offset = new THREE.Spherical().setFromVector3(camera.position.clone().sub(controls.target));
        offset.theta += 0.08 * (arrow?.[0] ?? 0);
        offset.phi = Math.min(Math.max(offset.phi - 0.08 * (arrow?.[1] ?? 0), 0.01), Math.PI - 0.01);
        offset.radius *= zoom ?? 1;
        camera.position.setFromSpherical(offset).add(controls.target);
        camera.lookAt(controls.target);
        keep();
    });
    let fieldOfView = 32;
    return {
        camera, controls,
        // A picture that is narrower than 3 to 2 shows as much across.
        setAspect: (aspect) => {
            const tangent = Math.tan(THREE.MathUtils.degToRad(fieldOfView / 2)) * Math.max(1, 1.5 / aspect);
            camera.fov = 2 * THREE.MathUtils.radToDeg(Math.atan(tangent));
            camera.aspect = aspect;
            camera.updateProjectionMatrix();
        },
        // given: the state's six numbers, or the scene's camera.
        place: (given, {eye, target, fieldOfView: angle}) => {
            fieldOfView = angle;
            camera.position.set(...(given?.slice(0, 3) ?? eye));
            controls.target.set(...(given?.slice(3) ?? target));
            controls.update();
            camera.updateMatrixWorld();
        },
    };
}
