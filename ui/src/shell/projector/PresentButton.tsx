import { Projector } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { presentProgram, presentRuns } from "./present";

type PresentButtonProps =
  | {
      first: string;
      /** A run beside the first one. */
      second?: string;
    }
  | {
      program: string;
      /** Words beside the icon. */
      children?: ComponentChildren;
    };

/** Shows a run, two side by side, or a program on the projector. */
export function PresentButton(shown: PresentButtonProps) {
  const { show } = texts.value.projector;
  const ofRuns = "first" in shown;
  return (
    <Button
      icon={Projector}
      label={show}
      tip={show}
      testId="present"
      data-run={ofRuns ? shown.first : undefined}
      data-program={ofRuns ? undefined : shown.program}
      onPress={() =>
        ofRuns ? presentRuns(shown.first, shown.second ?? null) : presentProgram(shown.program)
      }
    >
      {ofRuns ? undefined : shown.children}
    </Button>
  );
}
