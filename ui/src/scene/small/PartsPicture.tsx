import type { Area } from "../areas";
import type { Part } from "../mat/parts";
import type { GoalViewport } from "./goal_viewport";

interface PartsPictureProps {
  parts: readonly Part[];
  /** Where the drawing lies on the floor. */
  area: Area;
  viewport: GoalViewport;
  class: string;
}

/** A drawing of the mat in a small picture. */
export function PartsPicture({ parts, area, viewport, class: name }: PartsPictureProps) {
  const { x, y } = viewport.toPixels(area);
  const { scale } = viewport;
  return (
    <g
      class={name}
      transform={`translate(${x} ${y}) rotate(${-area.heading}) scale(${scale} ${-scale})`}
    >
      {parts.map(({ d, fill = "none", line = "none", width, dash }, index) => (
        <path
          key={index}
          d={d}
          fill={fill}
          stroke={line}
          stroke-width={width}
          stroke-dasharray={dash?.join(" ")}
        />
      ))}
    </g>
  );
}
