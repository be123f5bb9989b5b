import { useSignal } from "@preact/signals";
import { keeping } from "../api/keeping";
import type { OpenProgram } from "../app/open_program";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { WayBack } from "./WayBack";

/** Whoever has a program on the desk that was thrown away, in whatever window, is told so, with the way back. */
export function InBin({ open }: { open: OpenProgram }) {
  const closed = useSignal(false);
  if (closed.value || !open.inBin.value || open.deleted.value) return null;
  const words = texts.value.keeping;
  const takeBack = async () => {
    await keeping.takeBack(open.id);
    open.inBin.value = false;
  };
  return (
    <WayBack
      words={words.inBin}
      action={words.takeBack}
      testId={TEST.takeBack}
      onBack={() => void takeBack().catch(report)}
      onClose={() => {
        closed.value = true;
      }}
    />
  );
}
