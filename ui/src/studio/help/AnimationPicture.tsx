import { Play } from "lucide-preact";
import { useMemo } from "preact/hooks";
import { texts } from "../../i18n";
import { labelled } from "../../i18n/phrases";
import { Button } from "../../kit/Button";
import { GroundPicture, ObjectsPicture } from "../../scene/small/GroundPicture";
import { HEIGHT, viewportOfGoal, WIDTH } from "../../scene/small/goal_viewport";
import { WaitingRobot } from "../../scene/small/PathPicture";
import { Line, StartMark } from "../../scene/small/parts";
import { prefersStill } from "../../shell/theme";
import { type BlockAnimation, driven, floorOf, poseAt } from "./animation";
import { usePlaying } from "./playing";

interface AnimationPictureProps {
  animation: BlockAnimation;
  /** The text of the block. */
  label: string;
}

/**
 * Animation of the robot at a block. Plays once when it comes into view, and when pressed. With
 * reduced motion, shows its end.
 */
export function AnimationPicture({ animation, label }: AnimationPictureProps) {
  const isStill = prefersStill();
  const { part, place, play } = usePlaying(animation, isStill);
  const picture = <Floor film={animation} part={part} />;
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
      label={labelled(texts.value.help.playFilm, label)}
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

function Floor({ film: animation, part }: { film: BlockAnimation; part: number }) {
  const goal = useMemo(() => floorOf(animation), [animation]);
  const viewport = useMemo(() => viewportOfGoal(goal), [goal]);
  const [x, y, heading] = poseAt(animation, part);
  const robot = viewport.toPixels({ x, y });
  return (
    <svg class="goal" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
      <GroundPicture goal={goal} viewport={viewport} />
      <ObjectsPicture goal={goal} viewport={viewport} />
      <StartMark at={viewport.toPixels({ x: 0, y: 0 })} />
      <Line points={driven(animation, part)} viewport={viewport} edged={false} />
      {animation.strokes.map(({ color, from, to }) => (
        <Line
          key={from}
          points={driven(animation, part, from, to)}
          viewport={viewport}
          color={color}
        />
      ))}
      <g transform={`translate(${robot.x} ${robot.y}) rotate(${-heading})`}>
        <WaitingRobot at={[0, 0]} />
      </g>
    </svg>
  );
}
