import { BufferAttribute, BufferGeometry, Color, Mesh, ShaderMaterial } from "three";

/** Height of the picture at which the horizon's colour begins, from -1 below to 1 above. */
const HORIZON = -0.24;

/** The corners are in the picture's frame, as far away as anything can be. */
const VERTEX = `
varying float height;
void main() {
  height = position.y;
  gl_Position = vec4(position.xy, 1.0, 1.0);
}`;
const FRAGMENT = `
uniform vec3 high;
uniform vec3 low;
varying float height;
void main() {
  gl_FragColor = vec4(mix(low, high, smoothstep(${HORIZON.toFixed(2)}, 1.0, height)), 1.0);
}`;

/**
 * The background: one colour above, another below. It is drawn after everything else, only where nothing is: a picture in
 * the background took half of a frame on PCs without a graphics card.
 */
export class Sky {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;

  constructor() {
    const geometry = new BufferGeometry();
    // one triangle that covers the picture
    const corners = new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]);
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    const uniforms = { high: { value: new Color() }, low: { value: new Color() } };
    const material = new ShaderMaterial({
      uniforms,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      depthWrite: false,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 8.5;
  }

  setColours(high: string, low: string): void {
    const { uniforms } = this.mesh.material;
    // mixed as the screen shows them, and not converted in the shader
    uniforms.high?.value.set(high).convertLinearToSRGB();
    uniforms.low?.value.set(low).convertLinearToSRGB();
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
