import { Projector } from "lucide-preact";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { present } from "./present";

interface PresentButtonProps {
  first: string;
  /** A run beside the first one. */
  second?: string;
}

/** Shows a run, or two side by side, on the projector. */
export function PresentButton({ first, second }: PresentButtonProps) {
  const { show } = texts.value.projector;
  return (
    <Button
      icon={Projector}
      label={show}
      tip={show}
      testId="present"
      data-run={first}
      onPress={() => present(first, second ?? null)}
    />
  );
}
