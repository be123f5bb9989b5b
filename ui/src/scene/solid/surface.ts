import { AmbientLight, type Camera, DirectionalLight, Scene, WebGLRenderer } from "three";
import type { Atmosphere } from "./materials";
import { frameSize, type Quality } from "./quality";
import { Sky } from "./sky";

/** No WebGL: the browser has none, or it is switched off. */
export class NoWebglError extends Error {}

/** Names under which browsers draw without a graphics card. WebKit does not tell. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** The step of the quality to begin with: a guess by the name of the graphics card, which frames then correct. */
export function firstLevel(): number {
  const context = document.createElement("canvas").getContext("webgl2");
  const names = context?.getExtension("WEBGL_debug_renderer_info");
  const name = names ? String(context?.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return SOFTWARE.test(name) ? 1 : 0;
}

/** Draws a scene on a canvas: context, light, sky and the size of a frame. */
export class Surface {
  readonly scene = new Scene();
  private readonly context: WebGL2RenderingContext;
  private readonly renderer: WebGLRenderer;
  private readonly ambient = new AmbientLight();
  private readonly sun = new DirectionalLight();
  private readonly sky = new Sky();
  private size: [width: number, height: number] = [1, 1];

  constructor(
    canvas: HTMLCanvasElement,
    private quality: Quality,
  ) {
    const { antialias } = quality;
    // asked for here, because three.js writes an error to the console where there is none
    const context = canvas.getContext("webgl2", { antialias, alpha: false, stencil: false });
    if (!context) throw new NoWebglError();
    this.context = context;
    this.renderer = new WebGLRenderer({ canvas, context, antialias });
    // from above left, as in the drawing from above
    this.sun.position.set(-0.45, 0.75, 1.2);
    this.scene.add(this.ambient, this.sun, this.sky.mesh);
  }

  setAtmosphere({ high, low, ambient, sun }: Atmosphere): void {
    this.ambient.intensity = ambient;
    this.sun.intensity = sun;
    this.sky.setColours(high, low);
  }

  setQuality(quality: Quality): void {
    this.quality = quality;
    this.resize(this.size);
  }

  /** Sets the size of the view in pixels of the page; the frame is stretched to it. */
  resize(size: [width: number, height: number]): void {
    this.size = size;
    const [width, height] = frameSize(this.quality, size, window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
  }

  render(camera: Camera): void {
    this.renderer.render(this.scene, camera);
  }

  /** Draws a frame of another size and copies it. */
  picture(camera: Camera, [width, height]: readonly [number, number]): HTMLCanvasElement {
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [width, height];
    this.renderer.setSize(width, height, false);
    this.render(camera);
    // in the same task: the browser clears the canvas after it
    copy.getContext("2d")?.drawImage(this.renderer.domElement, 0, 0);
    this.resize(this.size);
    return copy;
  }

  /** Frees all memory of the graphics card at once: browsers allow only some contexts. */
  dispose(): void {
    this.sky.dispose();
    this.renderer.dispose();
    this.context.getExtension("WEBGL_lose_context")?.loseContext();
  }
}
