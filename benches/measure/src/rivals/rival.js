// Draws the demo's scenes with three.js, and times the frames: the same triangles, lights, camera
// and size of the picture, one sample a pixel.
import * as three from "three";

const middle = (times) => times.toSorted((a, b) => a - b)[times.length >> 1];

/** The linear colour of a light or a material. */
const color = ([red, green, blue]) => new three.Color().setRGB(red, green, blue, three.LinearSRGBColorSpace);

function mesh({ albedo, specular, shininess, positions, normals }, hasShadows) {
  const geometry = new three.BufferGeometry();
  geometry.setAttribute("position", new three.Float32BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new three.Float32BufferAttribute(normals, 3));
  const surface = { color: color(albedo), specular: color(specular), shininess };
  const object = new three.Mesh(geometry, new three.MeshPhongMaterial(surface));
  object.castShadow = object.receiveShadow = hasShadows;
  return object;
}

class Rival {
  #renderer;
  #scene = new three.Scene();
  #camera;
  #lights;
  #frames;
  #warmUp;
  #size;

  constructor({ size, fieldOfView, ambient, meshes, spots, shadows, warmUp, frames }) {
    const [width, height] = (this.#size = size);
    this.#renderer = new three.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true });
    this.#renderer.setPixelRatio(1);
    this.#renderer.setSize(width, height);
    this.#renderer.shadowMap.enabled = shadows > 0;
    document.body.replaceChildren(this.#renderer.domElement);
    this.#camera = new three.PerspectiveCamera((180 / Math.PI) * fieldOfView, width / height, 0.05, 100);
    this.#scene.add(new three.AmbientLight(color(ambient), Math.PI));
    for (const each of meshes) this.#scene.add(mesh(each, shadows > 0));
    this.#lights = spots.map((spot) => {
      // three.js divides the light by pi, and a penumbra of 1 is its softest edge.
      const light = new three.SpotLight(color(spot.color), Math.PI * spot.intensity, 0, spot.halfAngle, 1, 2);
      light.castShadow = shadows > 0;
      light.shadow.mapSize.set(shadows, shadows);
      this.#scene.add(light, light.target);
      return light;
    });
    [this.#frames, this.#warmUp] = [frames, warmUp];
  }

  /** The name of what draws. */
  get renderer() {
    const gl = this.#renderer.getContext();
    return gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL);
  }

  /** The triangles of the last frame, those of shadow maps included. */
  get triangles() {
    return this.#renderer.info.render.triangles;
  }

  /** Draws a frame, and waits until it is drawn. */
  #draw({ positions, axes }, { eye, target }) {
    this.#lights.forEach((light, number) => {
      light.position.fromArray(positions[number]);
      light.target.position.fromArray(positions[number]).add(new three.Vector3(...axes[number]));
    });
    this.#camera.position.fromArray(eye);
    this.#camera.lookAt(...target);
    this.#renderer.render(this.#scene, this.#camera);
    const gl = this.#renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** The median time of frames in which the lights move, and the camera if `isTurning`. In milliseconds. */
  async time(isTurning) {
    const times = [];
    for (const [number, frame] of this.#frames.entries()) {
      const camera = isTurning ? frame.camera : this.#frames[0].camera;
      const start = performance.now();
      this.#draw(frame, camera);
      if (number >= this.#warmUp) times.push(performance.now() - start);
      await new Promise((resolve) => setTimeout(resolve));
    }
    return middle(times);
  }

  /** The share of pixels that are not black. */
  litShare() {
    const gl = this.#renderer.getContext();
    const [width, height] = this.#size;
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let lit = 0;
    for (let i = 0; i < pixels.length; i += 4) lit += pixels[i] + pixels[i + 1] + pixels[i + 2] > 12;
    return lit / (width * height);
  }
}

/** Times a load: with the camera at rest, and with a turning camera. */
window.rival = async (file) => {
  const rival = new Rival(await (await fetch(file)).json());
  const [atRest, moving] = [await rival.time(false), await rival.time(true)];
  return { renderer: rival.renderer, triangles: rival.triangles, lit: rival.litShare(), atRest, moving };
};
document.body.dataset.state = "ready";
