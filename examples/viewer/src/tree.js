// The gallery's tree, tree.cpp: a seed grows the same one there and here.
import * as THREE from "three";
import {anyPerpendicular, cross, plus, times, unit} from "./mesh.js";

const BARK = [0.33, 0.25, 0.18];
const LEAF = [0.30, 0.42, 0.16];
const FORKS = 5;
const BRANCHES_PER_FORK = 3;
const LEAVES_PER_TWIG = 9;
const LEAF_LENGTH = 0.17;

// The Mersenne twister MT19937 of Matsumoto & Nishimura, which is std::mt19937.
class Random {
    constructor(seed) {
        this.words = new Uint32Array(624);
        this.words[0] = seed;
        for (let i = 1; i < 624; ++i)
            this.words[i] = Math.imul(1812433253, this.words[i - 1] ^ this.words[i - 1] >>> 30) + i;
        this.next = 624;
    }

    refill() {
        for (let i = 0; i < 624; ++i) {
            const joined = this.words[i] & 0x80000000 | this.words[(i + 1) % 624] & 0x7fffffff;
            this.words[i] = this.words[(i + 397) % 624] ^ joined >>> 1 ^ (joined & 1 ? 0x9908b0df : 0);
        }
        this.next = 0;
    }

    word() {
        if (this.next === 624)
            this.refill();
        let y = this.words[this.next++];
        y ^= y >>> 11;
        y ^= y << 7 & 0x9d2c5680;
        y ^= y << 15 & 0xefc60000;
        return (y ^ y >>> 18) >>> 0;
    }

    uniform(low, high) {
        return low + (high - low) * (this.word() >>> 8) / 2 ** 24;
    }
}

function tilted(axis, around, angle) {
    const side = new THREE.Vector3(...anyPerpendicular(axis)).applyAxisAngle(new THREE.Vector3(...axis), around);
    return unit(plus(times(axis, Math.cos(angle)), times(side.toArray(), Math.sin(angle))));
}

function addLeaf(builder, random, stem) {
    const lean = random.uniform(0, 1);
    const facing = tilted([0, 1, 0], random.uniform(0, 2 * Math.PI), lean);
    const along = tilted(facing, random.uniform(0, 2 * Math.PI), Math.PI / 2);
    const across = times(cross(facing, along), 0.3 * LEAF_LENGTH);
    const middle = plus(stem, times(along, 0.5 * LEAF_LENGTH));
    const tip = plus(stem, times(along, LEAF_LENGTH));
    const colour = times(LEAF, random.uniform(0.8, 1.2));
    builder.addQuad(stem, plus(middle, times(across, -1)), tip, plus(middle, across), colour);
}

function grow(builder, random, from, direction, length, radius, forks) {
    const to = plus(from, times(direction, length));
    const end = radius * 0.66;
    builder.addBar(from, to, radius, end, BARK);
    if (forks === 0) {
        for (let i = 0; i < LEAVES_PER_TWIG; ++i) {
            const at = random.uniform(0.3, 1.2);
            addLeaf(builder, random, plus(times(from, 1 - at), times(to, at)));
        }
        return;
    }
    const turn = random.uniform(0, 2 * Math.PI);
    for (let i = 0; i < BRANCHES_PER_FORK; ++i) {
        const branch = tilted(direction, turn + 2 * Math.PI * i / BRANCHES_PER_FORK, random.uniform(0.45, 0.85));
        grow(builder, random, to, branch, length * random.uniform(0.62, 0.8), end, forks - 1);
    }
}

// A leafy tree with its trunk's foot at foot.
export function addTree(builder, foot, seed) {
    grow(builder, new Random(seed), foot, unit([0.08, 1.0, 0.05]), 1.9, 0.15, FORKS);
}
