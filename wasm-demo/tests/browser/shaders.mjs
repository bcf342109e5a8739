// What the exporter writes as a shader, drawn by WebGL, computes what the kernel does on the host.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";

import { chromium } from "../../../xtask/browser/launch.mjs";

/** The lights: a shader in each language, places as bits, and what the kernel computes there. */
const { lights } = JSON.parse(readFileSync(process.env.EXPECTED, "utf8"));

/**
 * Evaluates a function of a point and a normal in a fragment shader, which reads the places from a texture, points in
 * row 0 and normals in row 1. Returns the bits of two numbers of each place.
 */
function draw(source, bits) {
  const count = bits.length / 6;
  const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  if (!gl) throw new Error("this browser has no WebGL 2");
  const compile = (kind, text) => {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(`${gl.getShaderInfoLog(shader)}\n${text}`);
    return shader;
  };
  const program = gl.createProgram();
  // One triangle covers all pixels.
  gl.attachShader(program, compile(gl.VERTEX_SHADER, `#version 300 es
    void main() {
      gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
    }`));
  gl.attachShader(program, compile(gl.FRAGMENT_SHADER, source));
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
}

let browser;

before(async () => (browser = await chromium()));
after(() => browser?.close());

const words = new Uint32Array(1);
const toFloat = (bits) => ((words[0] = bits), new Float32Array(words.buffer)[0]);

for (const language of ["glsl", "wgsl"]) {
  test(`shaders in ${language} draw what the kernel computes`, async () => {
    const page = await browser.newPage();
    const worst = { falloff: 0, realPower: 0, ulp: 0, exact: 0 };
    let [places, lit] = [0, 0];
    for (const { name, texts, bits, isReal, expected } of lights) {
      const found = await page.evaluate(draw, texts[language], bits);
      assert.equal(found.length, 2 * expected.length, name);
      places += expected.length;
      for (const [i, place] of expected.entries()) {
        const [irradiance, falloff] = [toFloat(found[2 * i]), toFloat(found[2 * i + 1])];
        assert.ok(Number.isFinite(irradiance) && Number.isFinite(falloff), `${name}: ${irradiance}, ${falloff} at place ${i}`);
        // At the edge itself a rounding decides.
        if (!place) continue;
        const [arrives, kernel, exact] = [toFloat(place[0]), toFloat(place[1]), place[2]];
        const kind = isReal ? "realPower" : "falloff";
        worst[kind] = Math.max(worst[kind], 255 * Math.abs(falloff - kernel));
        if (exact !== null) worst.exact = Math.max(worst.exact, 255 * Math.abs(falloff - exact));
        lit += Number(arrives > 0);
        if (!isReal && kernel > 1 / 255 && arrives > 2 ** -126) worst.ulp = Math.max(worst.ulp, Math.abs(found[2 * i] - place[0]));
      }
    }
    // Of Chromium's software renderer. A GPU may round less or more; where the least is not 0, the kernel itself
    // differs by that much.
    const bounds = { falloff: [0, 1e-4], realPower: [1e-6, 0.02], exact: [1e-5, 0.02], ulp: [0, 1000] };
    const told = `${language}: ${places} places, ${lit} lit; differences in linear codes ${JSON.stringify(worst)}`;
    console.log(told);
    assert.ok(lit > places / 3, told);
    for (const [of, [least, most]] of Object.entries(bounds)) assert.ok(worst[of] >= least && worst[of] <= most, `expected ${of} in ${least} to ${most}; ${told}`);
    await page.close();
  });
}
