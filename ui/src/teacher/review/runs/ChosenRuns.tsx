import type { Signal } from "@preact/signals";
import { Columns2, X } from "lucide-preact";
import type { HistoryRun } from "../../../api/model";
import { texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { LinkButton } from "../../../kit/LinkButton";
import { hashOf } from "../../../shell/route";

interface ChosenRunsProps {
  chosen: Signal<readonly HistoryRun[]>;
}

/** The runs selected for comparison, at the bottom of the screen. */
export function ChosenRuns({ chosen }: ChosenRunsProps) {
  const { runs: labels } = texts.value.review;
  const [first, second] = chosen.value;
  const forget = () => {
    chosen.value = [];
  };
  if (!first) return null;
  return (
    <div class="runs__chosen card row middle gap-3" role="status">
      <span>{second ? labels.twoChosen : labels.oneChosen}</span>
      <Button icon={X} onPress={forget}>
        {labels.forget}
      </Button>
      {second && (
        <LinkButton
          kind="main"
          icon={Columns2}
          href={hashOf({ screen: "compare", first: first.id, second: second.id })}
          testId="compare-open"
        >
          {labels.compare}
        </LinkButton>
      )}
    </div>
  );
}
