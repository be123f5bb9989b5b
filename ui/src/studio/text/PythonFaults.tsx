import type { Fault } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";

interface TextPosition {
  readonly line: number;
  readonly column: number;
}

/** Line and column of a fault, from 1. */
export function positionOf({ params }: Fault): TextPosition {
  const { line, column } = params as Partial<Record<"line" | "column", unknown>>;
  return {
    line: typeof line === "number" ? line : 1,
    column: typeof column === "number" ? column : 1,
  };
}

interface PythonFaultsProps {
  faults: readonly Fault[];
  onGo(fault: Fault): void;
}

/** The faults of the text; a click moves the caret there. */
export function PythonFaults({ faults, onGo }: PythonFaultsProps) {
  const { python } = texts.value;
  return (
    <ul class="text__faults" aria-label={python.faults({ count: faults.length })} data-scrolls>
      {faults.map((fault) => {
        const { line, column } = positionOf(fault);
        return (
          <li key={`${line}/${column}/${fault.code}`}>
            <Button
              kind="bare"
              class="faults__fault row middle apart gap-3"
              testId="python-fault"
              data-code={fault.code}
              data-line={line}
              data-column={column}
              onPress={() => onGo(fault)}
            >
              <span>
                <span class="text__place">{python.place({ line, column })}</span>{" "}
                <strong>{fault.message}</strong> {fault.remedy}
              </span>
            </Button>
          </li>
        );
      })}
    </ul>
  );
}
