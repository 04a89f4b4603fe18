// A model that the user gives: glTF, GLB or OBJ. All of it becomes meshes in world space with colours and normals, fitted
// to a cube on the ground. What cannot be read is an error that names the file.
import * as THREE from "three";
import {GLTFLoader} from "three/addons/loaders/GLTFLoader.js";
import {OBJLoader} from "three/addons/loaders/OBJLoader.js";
import {makeModelScene} from "./scenes.js";

const LARGEST = 1.3;
const COLOUR = new THREE.Color(0.72, 0.68, 0.62);

const LOADERS = {
    gltf: async (file, resolve) => (await gltfLoader(resolve).parseAsync(await file.text(), "")).scene,
    glb: async (file, resolve) => (await gltfLoader(resolve).parseAsync(await file.arrayBuffer(), "")).scene,
    obj: async (file) => new OBJLoader().parse(await file.text()),
};

// What a .gltf refers to is looked for among the files that were given with it.
function gltfLoader(resolve) {
    const manager = new THREE.LoadingManager();
    manager.setURLModifier(resolve);
    return new GLTFLoader(manager);
}

function withColours(geometry, material) {
    const count = geometry.getAttribute("position").count;
    const base = material?.color ?? COLOUR;
    const own = material?.vertexColors ? geometry.getAttribute("color") : undefined;
    const colours = new Float32Array(3 * count);
    for (let i = 0; i < count; ++i)
        colours.set(own ? [own.getX(i) * base.r, own.getY(i) * base.g, own.getZ(i) * base.b] : base.toArray(), 3 * i);
    geometry.setAttribute("color", new THREE.BufferAttribute(colours, 3));
}

// One material for each mesh: that of a part, or the only one.
function flattened(object) {
    const meshes = [];
    object.updateMatrixWorld(true);
    object.traverse((part) => {
        if (!part.isMesh || !part.geometry.getAttribute("position"))
            return;
        const material = Array.isArray(part.material) ? part.material[0] : part.material;
        const geometry = part.geometry.clone().applyMatrix4(part.matrixWorld);
        if (!geometry.getAttribute("normal"))
            geometry.computeVertexNormals();
        withColours(geometry, material);
        for (const name of Object.keys(geometry.attributes))
            if (!["position", "normal", "color", "uv"].includes(name))
                geometry.deleteAttribute(name);
        const mesh = new THREE.Mesh(geometry);
        mesh.userData = {map: material?.map ?? null, cutoff: material?.alphaTest ?? 0};
        meshes.push(mesh);
    });
    return meshes;
}

// Moves the meshes onto the ground, the largest side LARGEST long; gives the size.
function fit(meshes) {
    const box = new THREE.Box3();
    for (const {geometry} of meshes) {
        const {array} = geometry.getAttribute("position");
        if (!array.every(Number.isFinite))
            throw new Error("has corners that are not finite");
        geometry.computeBoundingBox();
        box.union(geometry.boundingBox);
    }
    const size = box.getSize(new THREE.Vector3());
    const largest = Math.max(size.x, size.y, size.z);
    if (!Number.isFinite(largest) || !(largest > 0))
        throw new Error("has no triangles with any extent");
    const centre = box.getCenter(new THREE.Vector3());
    const matrix = new THREE.Matrix4().makeScale(...Array(3).fill(LARGEST / largest))
        .multiply(new THREE.Matrix4().makeTranslation(-centre.x, -box.min.y, -centre.z));
    meshes.forEach(({geometry}) => geometry.applyMatrix4(matrix));
    return size.multiplyScalar(LARGEST / largest).toArray();
}

// files: those that were dropped or chosen together; one of them is the model.
export async function loadModel(files) {
    const extension = (file) => file.name.toLowerCase().match(/\.(\w+)$/)?.[1];
    const model = files.find((file) => extension(file) in LOADERS);
    if (!model)
        throw new Error(`${files.map(({name}) => name).join(", ")}: no glTF, GLB or OBJ file`);
    const urls = new Map(files.map((file) => [file.name, URL.createObjectURL(file)]));
    try {
        const resolve = (url) => {
            const name = decodeURIComponent(url).replace(/^.*\//, "");
            if (!/^(data|blob):/.test(url) && !urls.has(name))
                throw new Error(`refers to ${name}, which was not given with it`);
            return urls.get(name) ?? url;
        };
        const meshes = flattened(await LOADERS[extension(model)](model, resolve));
        if (meshes.length === 0)
            throw new Error("has no triangles");
        return makeModelScene(model.name, meshes, fit(meshes));
    } catch (error) {
        throw new Error(`${model.name}: ${error.message || error}`);
    } finally {
        for (const url of urls.values())
            URL.revokeObjectURL(url);
    }
}
