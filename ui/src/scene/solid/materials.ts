import { LineBasicMaterial, type Material, MeshBasicMaterial, MeshLambertMaterial } from "three";
import type { Robot } from "../../api/model";
import { type Colours, readColours } from "../colours";
import { type Livery, liveryPaint } from "../livery/livery";
import { liveryTexture } from "./livery_texture";

/** Sky, lights and outlines of a theme. */
export interface Atmosphere {
  readonly high: string;
  readonly low: string;
  readonly ambient: number;
  readonly sun: number;
  /** Outlines in place of light and shadow, as high contrast needs them. */
  readonly isOutlined: boolean;
}

/** Colours of the floor as `#rrggbb`, so that they can be mixed: style sheets have some as `#rgb`. */
export function readSolidColours(): Colours {
  const colours = Object.entries(readColours()).map(([role, colour]) => [
    role,
    /^#[\da-f]{3}$/i.test(colour) ? colour.replace(/[\da-f]/gi, "$&$&") : colour,
  ]);
  return Object.fromEntries(colours) as Colours;
}

export function readAtmosphere({ print }: Colours): Atmosphere {
  const style = getComputedStyle(document.documentElement);
  const [high, low] = ["--floor-sky", "--floor-horizon"].map((token) =>
    style.getPropertyValue(token).trim(),
  );
  const strength = Number(print) || 0;
  const isDay = strength === 1;
  return {
    high: high || "#ffffff",
    low: low || "#ffffff",
    ambient: isDay ? 2.05 : 1.7,
    sun: isDay ? 1.4 : 1.1,
    isOutlined: strength === 0,
  };
}

/** The materials of a robot. The body shows the colour and the pattern of its group. */
export interface RobotMaterials {
  readonly body: MeshLambertMaterial;
  readonly deck: Material;
  readonly mark: Material;
  /** Parts whose colours are those of their corners. */
  readonly parts: Material;
  readonly lamp: MeshBasicMaterial;
  /** Outlines in high contrast. */
  readonly edge: LineBasicMaterial | null;
}

/** The one place that gives a robot its colours; a ghost is the second robot of a comparison. */
export function robotMaterials(
  robot: Robot,
  livery: Livery | null,
  colours: Colours,
  { isOutlined }: Atmosphere,
  isGhost: boolean,
): RobotMaterials {
  const glass = isGhost ? { transparent: true, opacity: 0.62 } : {};
  const own = isGhost ? { ...colours, robot: colours.start } : colours;
  const paint = liveryPaint(livery, own);
  const map = liveryTexture(robot, paint);
  return {
    body: new MeshLambertMaterial({ ...(map ? { map } : { color: paint.body }), ...glass }),
    deck: new MeshLambertMaterial({ color: colours.deck, ...glass }),
    mark: new MeshBasicMaterial({ color: colours.mark, ...glass }),
    parts: new MeshLambertMaterial({ vertexColors: true, ...glass }),
    lamp: new MeshBasicMaterial({ ...glass }),
    edge: isOutlined ? new LineBasicMaterial({ color: colours.mark }) : null,
  };
}

export function disposeMaterials(materials: RobotMaterials): void {
  materials.body.map?.dispose();
  for (const material of Object.values(materials)) material?.dispose();
}
