import { useSignalEffect } from "@preact/signals";
import { ChevronDown, ChevronUp } from "lucide-preact";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { DifferenceIcon } from "../../versions/DifferenceIcon";
import type { PairBlocks } from "./load_pair";

interface PairDifferencesProps {
  blocks: PairBlocks;
  isOneProgram: boolean;
}

/**
 * Description of the current difference between the blocks, and buttons to the other differences.
 */
export function PairDifferences({ blocks, isOneProgram }: PairDifferencesProps) {
  const { archive, review } = texts.value;
  useSignalEffect(() => {
    if (blocks.list.value.length > 0 && blocks.chosen.peek() === null) blocks.step(1);
  });
  const count = blocks.list.value.length;
  if (!isOneProgram) return <p class="compare__same">{review.compare.otherProgram}</p>;
  if (blocks.drawn.value === 0) return null;
  if (count === 0) return <p class="compare__same">{archive.nothingDiffers}</p>;
  return (
    <section class="compare__differences" aria-label={archive.differences({ count })}>
      <Difference blocks={blocks} />
      <Button
        icon={ChevronUp}
        label={archive.previous}
        disabled={count < 2}
        testId="difference-previous"
        onPress={() => blocks.step(-1)}
      />
      <Button
        icon={ChevronDown}
        label={archive.next}
        disabled={count < 2}
        testId="difference-next"
        onPress={() => blocks.step(1)}
      />
    </section>
  );
}

function Difference({ blocks }: { blocks: PairBlocks }) {
  const { archive, review } = texts.value;
  const place = blocks.chosen.value ?? 0;
  const { kinds = [] } = blocks.list.value[place] ?? {};
  const text = blocks.lines.value[place] ?? "";
  return (
    <p
      class="compare__difference"
      aria-live="polite"
      title={text}
      data-testid="difference"
      data-kind={kinds[0]}
    >
      {kinds.map((kind) => (
        <DifferenceIcon key={kind} kind={kind} />
      ))}
      <span class="compare__words" data-shortened>
        <strong>{kinds.map((kind) => archive.kinds[kind]).join(", ")}</strong> {text}
      </span>
      <span class="compare__place">
        {review.compare.place({ n: place + 1, all: blocks.list.value.length })}
      </span>
    </p>
  );
}
