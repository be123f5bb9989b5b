import {
  BufferAttribute,
  BufferGeometry,
  Color,
  CylinderGeometry,
  Euler,
  Matrix4,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Solid } from "../mat/solids";

/** Sides of what is round. */
const SIDES = 18;

/** Where bodies are on the floor: metres and radians, world frame. */
export interface Place {
  readonly x: number;
  readonly y: number;
  readonly yaw: number;
}

/** One geometry of many bodies, with a colour at each corner: the graphics card draws it at once. */
export function geometryOf(parts: readonly (readonly [Place, readonly Solid[]])[]): BufferGeometry {
  const geometries = parts.flatMap(([place, solids]) =>
    solids.map((solid) => bodyOf(solid).applyMatrix4(matrixOf(place))),
  );
  const merged = geometries.length > 0 ? mergeGeometries(geometries) : new BufferGeometry();
  for (const geometry of geometries) geometry.dispose();
  return merged;
}

const matrixOf = ({ x, y, yaw }: Place) =>
  new Matrix4().compose(
    new Vector3(x, y, 0),
    new Quaternion().setFromEuler(new Euler(0, 0, yaw)),
    new Vector3(1, 1, 1),
  );

function bodyOf({ form, at, size, top = 1, fill }: Solid): BufferGeometry {
  const [width, depth, height] = size;
  const body = FORMS[form](top, width >= depth);
  body.scale(width, depth, height).translate(...at);
  return coloured(body, fill);
}

/** Unit bodies on the floor around the z axis. */
const FORMS: Readonly<Record<Solid["form"], (top: number, isWide: boolean) => BufferGeometry>> = {
  block: (top) =>
    flat(upright(new CylinderGeometry(top * Math.SQRT1_2, Math.SQRT1_2, 1, 4), Math.PI / 4)),
  round: (top) => upright(new CylinderGeometry(top / 2, 0.5, 1, SIDES)).toNonIndexed(),
  ball: () => new SphereGeometry(0.5, 14, 10).translate(0, 0, 0.5).toNonIndexed(),
  roof: (_top, isWide) => roof().rotateZ(isWide ? 0 : Math.PI / 2),
};

/** Turns a body of three.js, whose axis is y, to stand on the floor. */
const upright = (body: BufferGeometry, turn = 0) =>
  body
    .rotateY(turn)
    .rotateX(Math.PI / 2)
    .translate(0, 0, 0.5);

/** Gives each side its own normal, so that edges are sharp. */
function flat(body: BufferGeometry): BufferGeometry {
  const sides = body.toNonIndexed();
  body.dispose();
  sides.computeVertexNormals();
  return sides;
}

/** A roof with the ridge along x; two slopes and two gables. */
function roof(): BufferGeometry {
  const [a, b, c, d] = [
    [-0.5, -0.5, 0],
    [0.5, -0.5, 0],
    [0.5, 0.5, 0],
    [-0.5, 0.5, 0],
  ] as const;
  const [left, right] = [
    [-0.5, 0, 1],
    [0.5, 0, 1],
  ] as const;
  const faces = [
    a,
    b,
    right,
    a,
    right,
    left,
    c,
    d,
    left,
    c,
    left,
    right,
    b,
    c,
    right,
    d,
    a,
    left,
    a,
    c,
    b,
    a,
    d,
    c,
  ];
  const body = new BufferGeometry();
  body.setAttribute("position", new BufferAttribute(new Float32Array(faces.flat()), 3));
  body.computeVertexNormals();
  return body;
}

/** Gives all corners of a body one colour. */
export function coloured(body: BufferGeometry, fill: string): BufferGeometry {
  const { r, g, b } = new Color(fill);
  const n = body.getAttribute("position").count;
  const colours = new Float32Array(3 * n);
  for (let at = 0; at < n; at++) colours.set([r, g, b], 3 * at);
  body.setAttribute("color", new BufferAttribute(colours, 3));
  body.deleteAttribute("uv"); // nothing here has a texture
  return body;
}
