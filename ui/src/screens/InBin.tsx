import { useSignal } from "@preact/signals";
import { keeping } from "../api/keeping";
import type { Program } from "../api/model";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { WayBack } from "./WayBack";

/** Whoever opens a program that was thrown away, from one of its runs, is told so, with the way back. */
export function InBin({ program }: { program: Program }) {
  const shown = useSignal(program.deleted_at !== null);
  if (!shown.value) return null;
  const words = texts.value.keeping;
  const takeBack = async () => {
    await keeping.takeBack(program.id);
    shown.value = false;
  };
  return (
    <WayBack
      words={words.inBin}
      action={words.takeBack}
      testId={TEST.takeBack}
      onBack={() => void takeBack().catch(report)}
      onClose={() => {
        shown.value = false;
      }}
    />
  );
}
