import { ArrowRight, TriangleAlert } from "lucide-preact";
import type { Fault } from "../api/model";
import { TEST } from "../app/testids";
import { texts } from "../i18n";

interface FaultListProps {
  faults: readonly Fault[];
  onGo(fault: Fault): void;
}

/** What keeps the program from running, in words; a click shows the block. */
export function FaultList({ faults, onGo }: FaultListProps) {
  const { studio } = texts.value;
  if (faults.length === 0) return null;
  return (
    <div class="faults" data-testid={TEST.faultList} role="status">
      <h2 class="faults__title">
        <TriangleAlert class="icon" aria-hidden="true" />
        {studio.faultsTitle(faults.length)}
      </h2>
      <ul class="faults__list">
        {faults.map((fault) => (
          <li key={`${fault.pointer}/${fault.code}`}>
            <button
              type="button"
              class="faults__fault"
              data-testid={TEST.fault}
              data-code={fault.code}
              disabled={!fault.block}
              title={studio.goToBlock}
              onClick={() => onGo(fault)}
            >
              <span>
                <strong>{fault.message}</strong> {fault.remedy}
              </span>
              {fault.block && <ArrowRight class="icon" aria-hidden="true" />}
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}
