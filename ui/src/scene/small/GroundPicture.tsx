import type { GoalPicture, World } from "../../api/model";
import { areaOf, lineThrough, outlineOf, WALL_M } from "../areas";
import { BOX_DRAWINGS } from "../mat/boxes";
import { GROUNDS } from "../mat/grounds";
import { PICTOGRAM_SIZE, pictogramOf } from "../mat/pictograms";
import { inkOn, isPictured, PICTOGRAM_PART } from "../mat/places";
import { printedParts } from "../mat/prints";
import { paintOf } from "../paints";
import { type GoalViewport, pointsOf } from "./goal_viewport";
import { PartsPicture } from "./PartsPicture";
import { Grid } from "./parts";

interface GroundProps {
  goal: GoalPicture;
  viewport: GoalViewport;
}

/** The floor of a goal: metre grid, colours and zones. */
export function GroundPicture({ goal: { world, zones }, viewport }: GroundProps) {
  return (
    <>
      <Tiles frame={viewport} />
      <PrintsPicture world={world} viewport={viewport} />
      {world.floor.map((paint, index) => (
        <Shape
          key={index}
          area={paint}
          viewport={viewport}
          class={world.ground ? "goal__paint goal__paint--full" : "goal__paint"}
          fill={paintOf(paint.color)}
        />
      ))}
      {world.zones.map((zone) => (
        <Shape
          key={zone.name}
          area={zone}
          viewport={viewport}
          class={zones.includes(zone.name) ? "goal__zone goal__zone--wanted" : "goal__zone"}
        />
      ))}
    </>
  );
}

/** The ground of a world and what is printed on it. */
function PrintsPicture({ world, viewport }: { world: World; viewport: GoalViewport }) {
  const [width, depth] = world.size_m;
  const room = areaOf({ center: [0, 0], size: [width, depth] });
  const [ground] = world.ground ? GROUNDS[world.ground](width, depth) : [];
  return (
    <g class="goal__prints">
      {ground && <PartsPicture parts={[ground]} area={room} viewport={viewport} class="" />}
      {printedParts(world.prints ?? []).map(({ print, part }, index) => (
        <PartsPicture
          key={index}
          parts={[part]}
          area={areaOf(print)}
          viewport={viewport}
          class=""
        />
      ))}
      {world.ground && <Grid viewport={viewport} />}
    </g>
  );
}

/** The objects on the floor: walls, boxes, and the targets of boxes to push. */
export function ObjectsPicture({ goal: { world, boxes }, viewport }: GroundProps) {
  return (
    <>
      {world.boxes.map((box, index) => (
        <Shape key={index} area={box} viewport={viewport} class="goal__box" />
      ))}
      {world.boxes.map((box, index) => {
        const area = areaOf(box);
        return (
          box.kind && (
            <PartsPicture
              key={index}
              parts={BOX_DRAWINGS[box.kind](area.width, area.depth, "")}
              area={area}
              viewport={viewport}
              class="goal__thing"
            />
          )
        );
      })}
      {Object.entries(boxes).map(([index, [x, y, yaw]]) => {
        const box = world.boxes[Number(index)];
        if (!box) return null;
        const there = { ...box, center: [x, y], heading_deg: (yaw * 180) / Math.PI } as typeof box;
        return (
          <Shape key={index} area={there} viewport={viewport} class="goal__box goal__box--wanted" />
        );
      })}
      <path
        class="goal__walls"
        stroke-width={Math.max(2, WALL_M * viewport.scale)}
        d={world.walls
          .map(({ from, to }) => lineThrough(pointsOf([from, to]).map(viewport.toPixels)))
          .join("")}
      />
    </>
  );
}

/** Longer names do not fit into a zone of this picture. */
const MAX_NAME_LENGTH = 2;
const NAME_M = 0.34;
const NAME_PLACE = 0.3;

/** Pictograms or names of zones, and a flag on each zone to reach if the goal has no lines. */
export function NamesPicture({ goal: { world, zones, lines }, viewport }: GroundProps) {
  return (
    <>
      {world.zones.map((zone) => {
        const { name, center, size } = zone;
        const { x, y } = viewport.toPixels(areaOf({ center }));
        if (isPictured(world, zone))
          return <Pictogram key={name} world={world} zone={zone} viewport={viewport} />;
        if (name.length <= MAX_NAME_LENGTH) {
          // in a corner of its zone, because lines lead to the middle
          const [dx = 0, dy = 0] = (size ?? []).map((side) => NAME_PLACE * side * viewport.scale);
          const font = Math.min(18, NAME_M * viewport.scale);
          return (
            <text key={name} class="goal__name" x={x - dx} y={y - dy} font-size={font}>
              {name}
            </text>
          );
        }
        const isFlagged = zones.includes(name) && lines.length === 0;
        return (
          isFlagged && (
            <path key={name} class="goal__flag" d={`M${x - 5} ${y + 10}v-21l14 6-14 6`} />
          )
        );
      })}
    </>
  );
}

interface PictogramProps {
  world: World;
  zone: World["zones"][number];
  viewport: GoalViewport;
}

/** The pictogram of a place on its field. */
function Pictogram({ world, zone, viewport }: PictogramProps) {
  const area = areaOf(zone);
  const { x, y } = viewport.toPixels(area);
  const scale =
    (PICTOGRAM_PART * Math.min(area.width, area.depth) * viewport.scale) / PICTOGRAM_SIZE;
  return (
    <path
      class="goal__pictogram"
      style={{ "--ink-on": inkOn(world, zone) ?? "var(--ink)" }}
      fill-rule="evenodd"
      transform={`translate(${x} ${y}) scale(${scale}) translate(${-PICTOGRAM_SIZE / 2} ${-PICTOGRAM_SIZE / 2})`}
      d={pictogramOf(zone.name) ?? ""}
    />
  );
}

function Tiles({ frame: viewport }: { frame: GoalViewport }) {
  const { left, right, bottom, top } = viewport.box;
  const { x, y } = viewport.toPixels({ x: left, y: top });
  const { x: x2, y: y2 } = viewport.toPixels({ x: right, y: bottom });
  return (
    <>
      <rect class="goal__floor" x={x} y={y} width={x2 - x} height={y2 - y} />
      <Grid viewport={viewport} />
    </>
  );
}

interface ShapeProps {
  area: World["floor"][number] | World["zones"][number] | World["boxes"][number];
  viewport: GoalViewport;
  class: string;
  fill?: string;
}

/** A disc or a rectangle on the floor. */
function Shape({ area, viewport: { toPixels, scale }, ...attributes }: ShapeProps) {
  return <path {...attributes} d={outlineOf(areaOf(area), toPixels, scale)} />;
}
