// Leaves that a texture cuts out of cards, as games have them: what is transparent casts no shadow.
import * as THREE from "three";

const TEXELS = 128;
const LEAVES = 26;
export const CUTOFF = 0.5;

// Leaves all over a square, as colour with their outline in alpha.
function leafTexture(next) {
    const data = new Uint8Array(4 * TEXELS * TEXELS);
    for (let leaf = 0; leaf < LEAVES; ++leaf) {
        const [x, y, turn, shade] = [0.12 + 0.76 * next(), 0.12 + 0.76 * next(), 2 * Math.PI * next(), 0.7 + 0.5 * next()];
        for (let i = 0; i < TEXELS * TEXELS; ++i) {
            const [dx, dy] = [(i % TEXELS + 0.5) / TEXELS - x, (Math.floor(i / TEXELS) + 0.5) / TEXELS - y];
            const [along, across] = [dx * Math.cos(turn) + dy * Math.sin(turn), dy * Math.cos(turn) - dx * Math.sin(turn)];
            if ((along / 0.11) ** 2 + (across / 0.045) ** 2 < 1)
                data.set([90 * shade, 130 * shade, 50 * shade, 255], 4 * i);
        }
    }
    const texture = new THREE.DataTexture(data, TEXELS, TEXELS);
    Object.assign(texture, {magFilter: THREE.LinearFilter, minFilter: THREE.LinearFilter, needsUpdate: true});
    return texture;
}

// Cards of a size around a middle, each turned its own way. next: numbers in [0,1). Result: one mesh.
export function makeCards(next, middle, reach, size, count) {
    const attributes = {position: [], normal: [], color: [], uv: []};
    for (let card = 0; card < count; ++card) {
        const place = new THREE.Vector3(...middle).add(new THREE.Vector3(next() - 0.5, next() - 0.5, next() - 0.5)
            .multiplyScalar(2 * reach));
        const turned = new THREE.Euler(Math.PI * next(), 2 * Math.PI * next(), Math.PI * next());
        const facing = new THREE.Vector3(0, 0, 1).applyEuler(turned);
        for (const [u, v] of [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]]) {
            const corner = new THREE.Vector3(u - 0.5, v - 0.5, 0).multiplyScalar(size).applyEuler(turned).add(place);
            attributes.position.push(...corner);
            attributes.normal.push(...facing);
            attributes.color.push(1, 1, 1);
            attributes.uv.push(u, v);
        }
    }
    const geometry = new THREE.BufferGeometry();
    for (const [name, values] of Object.entries(attributes))
        geometry.setAttribute(name, new THREE.Float32BufferAttribute(values, name === "uv" ? 2 : 3));
    const mesh = new THREE.Mesh(geometry);
    mesh.userData = {map: leafTexture(next), cutoff: CUTOFF};
    return mesh;
}
