// Evaluates a function of a point and a normal in a fragment shader.
//
// `places` has a point and a normal of each place: six numbers as the bits of f32. The shader reads
// them from the texture `places`, points in row 0 and normals in row 1, and writes two numbers as
// bits. Returns the numbers of all places.
((source, bits) => {
    const count = bits.length / 6;
    const canvas = new OffscreenCanvas(1, 1);
    const gl = canvas.getContext("webgl2");
    if (!gl) throw new Error("this browser has no WebGL 2");
    const shader = (kind, text) => {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
            throw new Error(`${gl.getShaderInfoLog(shader)}\n${text}`);
        }
        return shader;
    };
    const program = gl.createProgram();
    // One triangle covers all pixels.
    gl.attachShader(program, shader(gl.VERTEX_SHADER, `#version 300 es
        void main() {
            gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
        }`));
    gl.attachShader(program, shader(gl.FRAGMENT_SHADER, source));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    gl.useProgram(program);

    const words = new Uint32Array(8 * count);
    for (let i = 0; i < count; i++) {
        words.set(bits.slice(6 * i, 6 * i + 3), 4 * i);
        words.set(bits.slice(6 * i + 3, 6 * i + 6), 4 * (count + i));
    }
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, count, 2, 0, gl.RGBA, gl.FLOAT, new Float32Array(words.buffer));
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);

    // Integers as colours are part of WebGL 2; floats are an extension.
    const target = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, target);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32UI, count, 1);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, target);
    gl.viewport(0, 0, count, 1);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const pixels = new Uint32Array(4 * count);
    gl.readPixels(0, 0, count, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, pixels);
    if (gl.getError() !== gl.NO_ERROR) throw new Error("WebGL reports an error");
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return Array.from(pixels).filter((_, i) => i % 4 < 2);
})
