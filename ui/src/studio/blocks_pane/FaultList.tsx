import { ArrowRight, TriangleAlert } from "lucide-preact";
import type { Fault } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";

interface FaultListProps {
  faults: readonly Fault[];
  onGo(fault: Fault): void;
}

/** The faults of a program that cannot run; a click shows the block. */
export function FaultList({ faults, onGo }: FaultListProps) {
  const { studio } = texts.value;
  if (faults.length === 0) return null;
  return (
    <div class="faults" data-testid="fault-list" role="status">
      <h2 class="faults__title row middle gap-2">
        <TriangleAlert class="icon" aria-hidden="true" />
        {studio.faultsTitle({ count: faults.length })}
      </h2>
      <ul class="faults__list">
        {faults.map((fault) => (
          <li key={`${fault.pointer}/${fault.code}`}>
            <Button
              kind="bare"
              class="faults__fault row middle apart gap-3"
              iconEnd={fault.block ? ArrowRight : undefined}
              tip={studio.goToBlock}
              testId="fault"
              data-code={fault.code}
              disabled={!fault.block}
              onPress={() => onGo(fault)}
            >
              <span>
                <strong>{fault.message}</strong> {fault.remedy}
              </span>
            </Button>
          </li>
        ))}
      </ul>
    </div>
  );
}
