// A scene that bleeds light: a lattice over a table over the ground, an orthographic light, and a camera. In it any
// technique draws its shadow from one map, and beside it plain filtering of the same window, the truth.
import * as THREE from "three";

const MAP_SIZE = 512;
const TAPS = 7;
const VIEW = [480, 360];

function scene() {
    const made = new THREE.Scene();
    const box = (x, y, z, width, height, depth) => {
        const mesh = new THREE.Mesh(new THREE.BoxGeometry(width, height, depth));
        mesh.position.set(x, y, z);
        made.add(mesh);
    };
    box(0, -0.1, 0, 9, 0.2, 9);
    box(0, 2.3, 0, 4, 0.2, 3);
    for (const [x, z] of [[-1.8, -1.3], [1.8, -1.3], [-1.8, 1.3], [1.8, 1.3]])
        box(x, 1.1, z, 0.2, 2.2, 0.2);
    for (let i = -4; i <= 4; ++i) {
        box(0.7 * i, 4.6, 0, 0.25, 0.1, 6);
        box(0, 4.6, 0.7 * i, 6, 0.1, 0.25);
    }
    return made;
}

function light() {
    const camera = new THREE.OrthographicCamera(-5, 5, 5, -5, 3, 11);
    camera.position.set(1.5, 9, 1);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    return camera;
}

function view() {
    const camera = new THREE.PerspectiveCamera(40, VIEW[0] / VIEW[1], 0.1, 100);
    camera.position.set(-5, 6.5, 9);
    camera.lookAt(-0.4, 0.6, 0);
    return camera;
}

const VERTEX = `
out vec3 world;
out vec3 facing;
void main()
{
    vec4 placed = modelMatrix * vec4(position, 1.0);
    world = placed.xyz;
    facing = mat3(modelMatrix) * normal;
    gl_Position = projectionMatrix * viewMatrix * placed;
}`;
const FULL_SCREEN = {vertexShader: "void main() { gl_Position = vec4(position, 1.0); }", depthTest: false,
                     depthWrite: false};

function material(fragment, uniforms, more) {
    const wrapped = Object.fromEntries(Object.entries(uniforms).map(([name, value]) => [name, {value}]));
    return new THREE.ShaderMaterial({glslVersion: THREE.GLSL3, vertexShader: VERTEX, fragmentShader: fragment,
                                     uniforms: wrapped, ...more});
}

function target(width, height, type, filter) {
    return new THREE.WebGLRenderTarget(width, height, {type, minFilter: filter, magFilter: filter});
}

export class ShadowScene {
    // library: the text of lvsm_all.glsl, which #include <lvsm> stands for from then on.
    constructor(library) {
        THREE.ShaderChunk.lvsm = library;
        this.renderer = new THREE.WebGLRenderer({preserveDrawingBuffer: true});
        this.renderer.setSize(...VIEW);
        document.body.append(this.renderer.domElement);
        this.scene = scene();
        this.light = light();
        this.view = view();
        this.toLight = new THREE.Matrix4().multiplyMatrices(this.light.projectionMatrix, this.light.matrixWorldInverse);
        const triangle = new THREE.BufferGeometry();
        triangle.setAttribute("position",
                              new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
        this.fullScreen = new THREE.Mesh(triangle);
        this.fullScreen.frustumCulled = false;
        this.depths = this.drawMap("vec4 store(float depth, float split) { return vec4(depth); }", {},
                                   {type: THREE.FloatType, side: THREE.FrontSide});
        this.truth = this.judge(TRUTH, {map: this.depths.texture});
    }

    draw(into, material, scene, camera) {
        this.fullScreen.material = material;
        this.scene.overrideMaterial = material;
        this.renderer.setRenderTarget(into);
        this.renderer.render(scene, camera);
        material.dispose();
    }

    // A map of what store(float depth, float split), which chunk defines, makes of the light's depths.
    drawMap(chunk, uniforms, {type, side}) {
        const map = target(MAP_SIZE, MAP_SIZE, type, THREE.LinearFilter);
        const stored = (depth, more) => material(`#include <lvsm>
            uniform float split;
            ${chunk}
            layout(location = 0) out vec4 result;
            void main() { result = store(${depth}, split); }`, uniforms, more);
        // An empty texel holds depth 1, which not every technique stores as a colour that could be cleared to.
        this.renderer.autoClear = false;
        this.draw(map, stored("1.0", FULL_SCREEN), this.fullScreen, this.light);
        this.renderer.clearDepth();
        this.draw(map, stored("gl_FragCoord.z", {side}), this.scene, this.light);
        this.renderer.autoClear = true;
        return map;
    }

    // The map, filtered by a separable binomial of seven taps.
    blur(map, type) {
        let from = map;
        for (const direction of [new THREE.Vector2(1, 0), new THREE.Vector2(0, 1)]) {
            const to = target(MAP_SIZE, MAP_SIZE, type, THREE.LinearFilter);
            this.draw(to, material(BLUR, {map: from.texture, direction}, FULL_SCREEN), this.fullScreen, this.light);
            from.dispose();
            from = to;
        }
        return from;
    }

    // Each pixel of the view: visibility, and whether there is a surface that faces the light. chunk defines
    // float judged(vec2 uv, float depth, vec2 gradient), of the map's coordinates, the receiver's depth, and how that
    // changes from texel to texel.
    judge(chunk, uniforms) {
        const pixels = target(...VIEW, THREE.FloatType, THREE.NearestFilter);
        const extent = (this.light.right - this.light.left) / MAP_SIZE / (this.light.far - this.light.near);
        this.renderer.setClearColor(0, 0);
        const given = {...uniforms, toLight: this.toLight, lightView: this.light.matrixWorldInverse, extent};
        this.draw(pixels, material(`#include <lvsm>\n${chunk}\n${RECEIVE}`, given), this.scene, this.view);
        const read = new Float32Array(4 * VIEW[0] * VIEW[1]);
        this.renderer.readRenderTargetPixels(pixels, 0, 0, ...VIEW, read);
        pixels.dispose();
        return read;
    }

    // The light's depths, row by row, for lloydRelax and optimalSplits.
    readDepths() {
        const read = new Float32Array(4 * MAP_SIZE * MAP_SIZE);
        this.renderer.readRenderTargetPixels(this.depths, 0, 0, MAP_SIZE, MAP_SIZE, read);
        return {depths: read.filter((_, index) => index % 4 === 0), width: MAP_SIZE, height: MAP_SIZE};
    }

    // Visibility at each pixel by a technique: chunk defines store(float, float) and visibility(vec4, float, float).
    technique(chunk, uniforms, {type = THREE.HalfFloatType, side = THREE.FrontSide} = {}) {
        const map = this.blur(this.drawMap(chunk, uniforms, {type, side}), type);
        const pixels = this.judge(`uniform sampler2D map;
            uniform float split;
            ${chunk}
            float judged(vec2 uv, float depth, vec2 gradient) { return visibility(texture(map, uv), depth, split); }`,
                                  {...uniforms, map: map.texture});
        map.dispose();
        return pixels;
    }

    // Root mean square error in grey levels over the surfaces that face the light. A value that is no number counts as
    // 255.
    error(pixels) {
        let sum = 0, count = 0;
        for (let i = 0; i < pixels.length; i += 4) {
            if (this.truth[i + 3] === 0)
                continue;
            const error = 255 * (pixels[i] - this.truth[i]);
            sum += Number.isFinite(error) ? error * error : 255 * 255;
            ++count;
        }
        return Math.sqrt(sum / count);
    }

    // A picture of visibilities, as a data URL.
    picture(pixels) {
        const map = new THREE.DataTexture(pixels, ...VIEW, THREE.RGBAFormat, THREE.FloatType);
        map.needsUpdate = true;
        this.draw(null, material(SHOW, {map}, FULL_SCREEN), this.fullScreen, this.view);
        return this.renderer.domElement.toDataURL();
    }
}

const BLUR = `#include <lvsm>
uniform sampler2D map;
uniform vec2 direction;
layout(location = 0) out vec4 result;
void main()
{
    result = vec4(0.0);
    for (int tap = 0; tap < ${TAPS}; ++tap)
    {
        ivec2 texel = ivec2(gl_FragCoord.xy) + (tap - ${TAPS >> 1}) * ivec2(direction);
        texel = clamp(texel, ivec2(0), ivec2(${MAP_SIZE - 1}));
        result += lvsm_binomialWeight(tap, ${TAPS}) * texelFetch(map, texel, 0);
    }
}`;

// The depth test at every texel that the blur and a linear sample of it read, with the weights that these have.
const TRUTH = `
uniform sampler2D map;
float weight(int tap, float between)
{
    return mix(lvsm_binomialWeight(tap, ${TAPS}), lvsm_binomialWeight(tap - 1, ${TAPS}), between);
}
float judged(vec2 uv, float depth, vec2 gradient)
{
    vec2 position = uv * ${MAP_SIZE}.0 - 0.5;
    vec2 between = fract(position);
    float lit = 0.0;
    for (int y = 0; y <= ${TAPS}; ++y)
    {
        for (int x = 0; x <= ${TAPS}; ++x)
        {
            vec2 texel = floor(position) + vec2(x, y) - ${TAPS >> 1}.0;
            float receiver = lvsm_planeDepth(depth, gradient, texel - position);
            float occluder = texelFetch(map, clamp(ivec2(texel), ivec2(0), ivec2(${MAP_SIZE - 1})), 0).x;
            lit += weight(x, between.x) * weight(y, between.y) * lvsm_depthTest(occluder, receiver, 5.0e-4);
        }
    }
    return lit;
}`;

const RECEIVE = `
in vec3 world;
in vec3 facing;
uniform mat4 toLight, lightView;
uniform float extent;
layout(location = 0) out vec4 result;
void main()
{
    vec3 at = 0.5 * (toLight * vec4(world, 1.0)).xyz + 0.5;
    vec3 toEye = mat3(lightView) * normalize(facing);
    vec2 gradient = extent * toEye.xy / max(toEye.z, 0.01);
    bool faces = toEye.z > 0.5 && all(greaterThan(at, vec3(0.02))) && all(lessThan(at, vec3(0.98)));
    float visibility = judged(at.xy, at.z, gradient);
    result = faces ? vec4(vec3(visibility), 1.0) : vec4(0.0);
}`;

const SHOW = `
uniform sampler2D map;
layout(location = 0) out vec4 result;
void main()
{
    vec4 pixel = texelFetch(map, ivec2(gl_FragCoord.xy), 0);
    result = vec4(pixel.a > 0.0 ? pixel.rgb : vec3(0.2, 0.25, 0.3), 1.0);
}`;
