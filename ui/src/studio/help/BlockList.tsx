import { Plus } from "lucide-preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import type { TextKey } from "../../blocks/texts";
import type { BlockDrawing } from "../../editor/block_drawings";
import { texts } from "../../i18n";
import { labelled } from "../../i18n/phrases";
import { Button } from "../../kit/Button";
import { AnimationPicture } from "./AnimationPicture";
import { animationOf } from "./animation";
import { useHelpContent } from "./help_content";

interface BlockListProps {
  drawings: readonly BlockDrawing[];
}

/** Blocks as the toolbox draws them, each with its animation and a button that adds it to the program. */
export function BlockList({ drawings }: BlockListProps) {
  return (
    <ul class="help__blocks">
      {drawings.map((one) => (
        <li key={one.type} data-testid="help-block" data-block={one.type}>
          <HelpOfBlock drawing={one} />
        </li>
      ))}
    </ul>
  );
}

function HelpOfBlock({ drawing }: { drawing: BlockDrawing }) {
  const { type, text: label } = drawing;
  const { drawings, put } = useHelpContent();
  const { help, blocks } = texts.value;
  const animation = animationOf(type);
  const picture = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => picture.current?.replaceChildren(drawing.svg.cloneNode(true)), [drawing]);
  return (
    <>
      <div class="help__block row wrap middle apart gap-2">
        <div
          ref={picture}
          role="img"
          aria-label={label}
          class={`help__picture shrinks ${drawings.stageClasses}`}
        />
        <Button
          icon={Plus}
          label={labelled(help.tryIt, label)}
          tip={help.tryItHelp}
          testId="help-try"
          onPress={({ currentTarget }) => {
            put(type);
            currentTarget.focus();
          }}
        >
          {help.tryIt}
        </Button>
      </div>
      <div class="help__about-block row middle gap-3">
        {animation && <AnimationPicture animation={animation} label={label} />}
        <p>{blocks[`${type.toUpperCase()}_TIP` as TextKey]}</p>
      </div>
    </>
  );
}
