import { computed } from "@preact/signals";
import { useId } from "preact/hooks";
import type { Robot } from "../../api/model";
import { robotOf } from "../../shell/session";
import { theme } from "../../shell/theme";
import { type Colours, readColours } from "../colours";
import { extentOf, hullPath, onHull } from "../hull";
import { type Livery, type LiveryPaint, liveryPaint, patternFrame } from "./livery";

/** Colours of the floor in the current theme, with liveries in high contrast too: a group chooses by these pictures. */
const pictureColours = computed<Colours>(() => {
  theme.value; // the tokens of this theme are read
  return { ...readColours(), print: "1" };
});

/** Style of an element in whose small pictures robots have the colour of the group. */
export function liveryStyle(livery: Livery | null): Record<string, string> {
  return livery ? { "--livery": liveryPaint(livery, pictureColours.value).body } : {};
}

/** The angle at which the robot stands in its picture, degrees to the left of straight right. */
const HEADING_DEG = 60;

interface RobotPictureProps {
  livery: Livery | null;
  class?: string;
}

/** The default robot from above, in the livery of a group, as the floor draws it. */
export function RobotPicture({ livery, class: extra = "" }: RobotPictureProps) {
  const robot = robotOf(null);
  const reach = robot ? reachOf(robot) : 1;
  return (
    <svg
      class={`robot-picture ${extra}`}
      viewBox={`${-reach} ${-reach} ${2 * reach} ${2 * reach}`}
      data-pattern={livery?.pattern}
      aria-hidden="true"
    >
      {robot && (
        <g transform={`rotate(${-HEADING_DEG}) scale(1 -1)`}>
          <Wheels robot={robot} />
          <Body robot={robot} paint={liveryPaint(livery, pictureColours.value)} />
          <Deck robot={robot} />
        </g>
      )}
    </svg>
  );
}

/** Half the side of a square that shows the whole robot at any heading, metres. */
function reachOf({ hull_m, wheels }: Robot): number {
  const wheelEnds = wheels.map(({ x_m, y_m, radius_m, width_m }) => [
    Math.abs(x_m) + radius_m,
    Math.abs(y_m) + width_m / 2,
  ]);
  return 1.04 * Math.max(...[...hull_m, ...wheelEnds].map(([x = 0, y = 0]) => Math.hypot(x, y)));
}

function Wheels({ robot }: { robot: Robot }) {
  return robot.wheels.map(({ x_m, y_m, radius_m, width_m }) => (
    <rect
      key={`${x_m} ${y_m}`}
      fill="var(--robot-wheel)"
      x={x_m - radius_m}
      y={y_m - width_m / 2}
      width={2 * radius_m}
      height={width_m}
      rx={0.36 * width_m}
    />
  ));
}

function Body({ robot, paint: { body, pattern } }: { robot: Robot; paint: LiveryPaint }) {
  const clip = useId();
  const outline = hullPath(robot);
  const { x, unit } = patternFrame(robot);
  return (
    <>
      <clipPath id={clip}>
        <path d={outline} />
      </clipPath>
      <path d={outline} fill={body} />
      {pattern && (
        <g clip-path={`url(#${clip})`}>
          <path
            transform={`translate(${x} 0) scale(${unit})`}
            d={pattern.drawing.path}
            fill={pattern.drawing.line ? "none" : pattern.colour}
            stroke={pattern.drawing.line ? pattern.colour : "none"}
            stroke-width={pattern.drawing.line}
          />
        </g>
      )}
      <path
        d={outline}
        fill="none"
        stroke="var(--robot-deck)"
        stroke-width={0.05 * robot.radius_m}
      />
    </>
  );
}

/** Sonars, and the deck with the arrow ahead, as `robot.ts` draws them. */
function Deck({ robot }: { robot: Robot }) {
  const { back, length, width } = extentOf(robot);
  return (
    <>
      {robot.sonars.map(({ x_m, y_m }) => {
        const { x, y } = onHull(robot, { x: x_m, y: y_m });
        const radius = 0.05 * robot.radius_m;
        return <circle key={`${x_m} ${y_m}`} cx={0.9 * x} cy={0.9 * y} r={radius} fill="#e9b949" />;
      })}
      <rect
        fill="var(--robot-deck)"
        x={back + 0.15 * length}
        y={-0.31 * width}
        width={0.57 * length}
        height={0.62 * width}
        rx={0.19 * width}
      />
      <path
        fill="var(--robot-mark)"
        transform={`translate(${back} 0) scale(${length} ${width})`}
        d="M.69 0 .35.26.42 0 .35-.26z"
      />
    </>
  );
}
