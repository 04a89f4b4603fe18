// Triangles as the gallery's mesh.cpp adds them: flat colours, a normal to shade with, both sides drawn.
import * as THREE from "three";

export class MeshBuilder {
    positions = [];
    normals = [];
    colours = [];

    // corners, normals: three of each, as [x, y, z].
    addTriangle(corners, normals, colour) {
        for (let i = 0; i < 3; ++i) {
            this.positions.push(...corners[i]);
            this.normals.push(...normals[i]);
            this.colours.push(...colour);
        }
    }

    // Corners in turn around the quadrilateral.
    addQuad(a, b, c, d, colour) {
        const normal = unit(cross(minus(b, a), minus(c, a)));
        this.addTriangle([a, b, c], [normal, normal, normal], colour);
        this.addTriangle([a, c, d], [normal, normal, normal], colour);
    }

    addBox(low, high, colour) {
        const corner = (i) => [0, 1, 2].map((axis) => (i >> axis & 1 ? high : low)[axis]);
        // Corner numbers of the six sides, seen anticlockwise from outside.
        const sides = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        for (const side of sides)
            this.addQuad(...side.map(corner), colour);
    }

    // A tapering round bar, open at its ends.
    addBar(from, to, radiusFrom, radiusTo, colour) {
        const sides = 10;
        const axis = unit(minus(to, from));
        const right = anyPerpendicular(axis);
        const up = cross(axis, right);
        const outwards = (side) => {
            const angle = 2 * Math.PI * side / sides;
            return plus(times(right, Math.cos(angle)), times(up, Math.sin(angle)));
        };
        for (let side = 0; side < sides; ++side) {
            const [n0, n1] = [outwards(side), outwards(side + 1)];
            const [a, b] = [plus(from, times(n0, radiusFrom)), plus(from, times(n1, radiusFrom))];
            const [c, d] = [plus(to, times(n1, radiusTo)), plus(to, times(n0, radiusTo))];
            this.addTriangle([a, b, c], [n0, n1, n1], colour);
            this.addTriangle([a, c, d], [n0, n1, n0], colour);
        }
    }

    // A square of ground at height 0.
    addGround(halfWidth, colour) {
        const w = halfWidth;
        this.addQuad([-w, 0, w], [w, 0, w], [w, 0, -w], [-w, 0, -w], colour);
    }

    mesh() {
        const geometry = new THREE.BufferGeometry();
        for (const [name, values] of [["position", this.positions], ["normal", this.normals], ["color", this.colours]])
            geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(values), 3));
        return new THREE.Mesh(geometry);
    }
}

export const plus = (a, b) => a.map((value, i) => value + b[i]);
export const minus = (a, b) => a.map((value, i) => value - b[i]);
export const times = (a, factor) => a.map((value) => value * factor);
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a) => times(a, 1 / Math.hypot(...a));

export function anyPerpendicular(axis) {
    return unit(cross(axis, Math.abs(axis[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
}
