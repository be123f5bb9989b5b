import type { Language, World } from "../api/model";
import type { Texts } from "../i18n";
import { metres } from "../i18n/format";
import type { FloorMark } from "../run/output";
import { areaOf, contains } from "./areas";
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
  return world?.zones?.findLast((zone) => contains(areaOf(zone), { x, y }))?.name ?? "";
}
