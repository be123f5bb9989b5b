import { Play } from "lucide-preact";
import { useMemo } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { frameOfGoal, HEIGHT, WIDTH } from "../../scene/small/frame";
import { GroundPicture, ThingsPicture } from "../../scene/small/GroundPicture";
import { WaitingRobot } from "../../scene/small/PathPicture";
import { Line, StartMark } from "../../scene/small/parts";
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
  const frame = useMemo(() => frameOfGoal(goal), [goal]);
  const [x, y, heading] = poseAt(film, part);
  const robot = frame.place({ x, y });
  return (
    <svg class="goal" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
      <GroundPicture goal={goal} frame={frame} />
      <ThingsPicture goal={goal} frame={frame} />
      <StartMark at={frame.place({ x: 0, y: 0 })} />
      <Line points={driven(film, part)} frame={frame} edged={false} />
      {film.strokes.map(({ color, from, to }) => (
        <Line key={from} points={driven(film, part, from, to)} frame={frame} color={color} />
      ))}
      <g transform={`translate(${robot.x} ${robot.y}) rotate(${-heading})`}>
        <WaitingRobot at={[0, 0]} />
      </g>
    </svg>
  );
}
