// What every pass needs: targets that are kept while their size and format stay, materials that are kept by their text,
// and the library's uniform blocks.
import * as THREE from "three";

const FULL_SCREEN = "void main() { gl_Position = vec4(position, 1.0); }";

export class Passes {
    #targets = new Map();
    #materials = new Map();

    constructor(renderer, vertexOfScene) {
        this.renderer = renderer;
        this.vertexOfScene = vertexOfScene;
        const triangle = new THREE.BufferGeometry();
        triangle.setAttribute("position", new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
        this.fullScreen = new THREE.Mesh(triangle);
        this.fullScreen.frustumCulled = false;
        this.noCamera = new THREE.Camera();
        this.forget();
    }

    // What the context held of the blocks is lost with it; three.js brings back the rest.
    forget() {
        this.gl = this.renderer.getContext();
        this.block = this.gl.createBuffer();
    }

    // A target of this name: made anew when options differ. options: of a render target, with width and height, slices of
    // an array of textures, levels where it has more than one, and normalized.
    target(name, options) {
        const key = JSON.stringify(options);
        const old = this.#targets.get(name);
        if (old?.key === key)
            return old.target;
        old?.target.dispose();
        const {width, height, slices, levels = 1, normalized = false, ...rest} = options;
        const target = slices ? new THREE.WebGLArrayRenderTarget(width, height, slices, rest)
                              : new THREE.WebGLRenderTarget(width, height, rest);
        for (const texture of target.textures)
            Object.assign(texture, {normalized, mipmaps: levels > 1 ? Array(levels).fill({}) : []});
        this.#targets.set(name, {key, target});
        return target;
    }

    drop(name) {
        this.#targets.get(name)?.target.dispose();
        this.#targets.delete(name);
    }

    // uniforms: by name, objects {value}, which may be shared between materials.
    material(fragment, uniforms, {isScene = false, defines = {}, ...more} = {}) {
        const key = JSON.stringify([fragment, isScene, defines]);
        let material = this.#materials.get(key);
        if (!material) {
            material = new THREE.ShaderMaterial({
                glslVersion: THREE.GLSL3, vertexShader: isScene ? this.vertexOfScene : FULL_SCREEN, fragmentShader: fragment,
                defines, uniforms: {}, side: THREE.DoubleSide, vertexColors: isScene, depthTest: isScene,
                depthWrite: isScene, blending: THREE.NoBlending, ...more,
            });
            this.#materials.set(key, material);
        }
        for (const [name, uniform] of Object.entries(uniforms))
            if (material.uniforms[name] !== uniform)
                material.uniforms[name] = uniform;
        material.uniformsNeedUpdate = true;
        return material;
    }

    drawScene(target, material, scene, camera) {
        scene.overrideMaterial = material;
        this.renderer.setRenderTarget(target);
        this.renderer.render(scene, camera);
    }

    // Over a slice of the target, or the square at its corner that is extent wide; or over so many layers from the first on
    // at once. block: data of the shader's one uniform block, if it has any.
    drawOver(target, material, {slice = 0, layers = 1, extent, block} = {}) {
        if (block) {
            this.gl.bindBuffer(this.gl.UNIFORM_BUFFER, this.block);
            this.gl.bufferData(this.gl.UNIFORM_BUFFER, block, this.gl.STREAM_DRAW);
            this.gl.bindBufferBase(this.gl.UNIFORM_BUFFER, 0, this.block);
        }
        target?.viewport.set(0, 0, extent ?? target.width, extent ?? target.height);
        this.fullScreen.material = material;
        this.renderer.setRenderTarget(target, slice);
        if (layers > 1)
            this.attachLayers(target, layers);
        this.renderer.render(this.fullScreen, this.noCamera);
    }

    // Of an array of textures three.js attaches one.
    attachLayers({texture}, layers) {
        const {gl} = this;
        const attachments = Array.from({length: layers}, (_, layer) => gl.COLOR_ATTACHMENT0 + layer);
        const array = this.renderer.properties.get(texture).__webglTexture;
        attachments.forEach((at, layer) => gl.framebufferTextureLayer(gl.FRAMEBUFFER, at, array, 0, layer));
        gl.drawBuffers(attachments);
    }

    // What has just been drawn, the square at its corner, becomes a level of a slice of an array of textures.
    copyInto({texture}, slice, level, extent) {
        const {gl} = this;
        this.renderer.state.bindTexture(gl.TEXTURE_2D_ARRAY, this.renderer.properties.get(texture).__webglTexture);
        gl.copyTexSubImage3D(gl.TEXTURE_2D_ARRAY, level, 0, 0, slice, 0, 0, extent, extent);
    }

    read(target, width, height) {
        const values = new Float32Array(4 * width * height);
        this.renderer.readRenderTargetPixels(target, 0, 0, width, height, values);
        return values;
    }
}

export const uniformsOf = (values) => Object.fromEntries(Object.entries(values).map(([name, value]) => [name, {value}]));
