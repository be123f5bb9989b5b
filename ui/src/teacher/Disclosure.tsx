import { ChevronDown, ChevronRight } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { Button } from "../kit/Button";

interface DisclosureProps {
  label: string;
  testId: string;
  children: ComponentChildren;
}

/** A part that a button folds and unfolds; what was typed in it stays. */
export function Disclosure({ label, testId, children }: DisclosureProps) {
  const [open, setOpen] = useState(false);
  return (
    <div class="disclosure">
      <Button
        kind="plain"
        class="disclosure__button"
        icon={open ? ChevronDown : ChevronRight}
        open={open}
        testId={testId}
        onPress={() => setOpen(!open)}
      >
        {label}
      </Button>
      <div class="disclosure__part" hidden={!open}>
        {children}
      </div>
    </div>
  );
}
