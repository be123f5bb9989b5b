import { Play } from "lucide-preact";
import { useMemo } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { GroundPicture, ThingsPicture } from "../../scene/goal/GroundPicture";
import { frameOf, type GoalFrame, HEIGHT, WIDTH } from "../../scene/goal/goal_frame";
import { WaitingRobot } from "../../scene/PathPicture";
import { paintOf } from "../../scene/paints";
import { prefersStill } from "../../shell/theme";
import { driven, type Film, floorOf, poseAt } from "./film";
import { usePlaying } from "./playing";

interface FilmPictureProps {
  film: Film;
  /** What the block says. */
  words: string;
}

/** What the robot does at a block: plays once when it comes into view, and when pressed; still where motion is reduced. */
export function FilmPicture({ film, words }: FilmPictureProps) {
  const isStill = prefersStill();
  const { part, place, play } = usePlaying(film, isStill);
  const picture = <Floor film={film} part={part} />;
  if (isStill) {
    return (
      <div class="help__film" data-testid="help-film">
        {picture}
      </div>
    );
  }
  return (
    <Button
      kind="bare"
      class="help__film"
      elementRef={place}
      label={`${texts.value.help.playFilm}: ${words}`}
      tip={texts.value.help.playFilm}
      testId="help-film"
      data-part={part.toFixed(2)}
      onPress={play}
    >
      {picture}
      {part === 1 && <Play class="icon" aria-hidden="true" />}
    </Button>
  );
}

function Floor({ film, part }: { film: Film; part: number }) {
  const goal = useMemo(() => floorOf(film), [film]);
  const frame = useMemo(() => frameOf(goal), [goal]);
  const [x, y, heading] = poseAt(film, part);
  const robot = frame.place([x, y]).join(" ");
  const [x0, y0] = frame.place([0, 0]);
  return (
    <svg class="goal" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
      <GroundPicture goal={goal} frame={frame} />
      <ThingsPicture goal={goal} frame={frame} />
      <circle class="path-picture__start" cx={x0} cy={y0} r="5" />
      <Line points={driven(film, part)} frame={frame} />
      {film.strokes.map(({ color, from, to }) => (
        <Line key={from} points={driven(film, part, from, to)} frame={frame} color={color} />
      ))}
      <g transform={`translate(${robot}) rotate(${-heading})`}>
        <WaitingRobot at={[0, 0]} />
      </g>
    </svg>
  );
}

interface LineProps {
  points: readonly (readonly number[])[];
  frame: GoalFrame;
  color?: string;
}

function Line({ points, frame, color }: LineProps) {
  const line = points.map((point) => frame.place(point).join()).join(" ");
  return (
    <g style={color ? { "--goal-line": paintOf(color) } : {}}>
      {color && <polyline class="goal__edge" points={line} />}
      <polyline class="goal__line" points={line} />
    </g>
  );
}
