import type { Language, World } from "../api/model";
import type { Texts } from "../i18n";
import { metres } from "../i18n/format";
import type { FloorMark } from "../run/output";
import { startOf, toWorld, type XY } from "./frames";

/** Description of a mark for screen readers: the symbol, and the place or else the coordinates. */
export function markText(
  mark: FloorMark,
  world: World | null,
  { scene }: Texts,
  language: Language,
): string {
  const place = placeAt(world, toWorld(startOf(world), mark.x, mark.y));
  if (place) return scene.markIn({ symbol: mark.symbol, place });
  return scene.markAt({
    symbol: mark.symbol,
    x: metres(mark.x, language),
    y: metres(mark.y, language),
  });
}

/** Name of the place of the world at a point, the last one if several overlap; "" outside all places. */
export function placeAt(world: World | null, { x, y }: XY): string {
  return world?.zones?.findLast((zone) => isInside(zone, x, y))?.name ?? "";
}

function isInside(zone: World["zones"][number], x: number, y: number): boolean {
  const [cx = 0, cy = 0] = zone.center;
  const [dx, dy] = [x - cx, y - cy];
  if (zone.radius) return Math.hypot(dx, dy) <= zone.radius;
  const [width = 0, depth = 0] = zone.size ?? [];
  const angle = ((zone.heading_deg ?? 0) * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return Math.abs(dx * cos + dy * sin) <= width / 2 && Math.abs(dy * cos - dx * sin) <= depth / 2;
}
