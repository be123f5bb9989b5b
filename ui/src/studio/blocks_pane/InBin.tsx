import { useSignal } from "@preact/signals";
import { versionsApi } from "../../api/versions";
import { texts } from "../../i18n";
import { WayBack } from "../../kit/WayBack";
import type { OpenProgram } from "../program/open_program";

/** Reports that the open program was moved to the bin, in any window, and offers undo. */
export function InBin({ open }: { open: OpenProgram }) {
  const closed = useSignal(false);
  if (closed.value || !open.inBin.value || open.deleted.value) return null;
  const words = texts.value.keeping;
  const takeBack = async () => {
    await versionsApi.takeBack(open.id);
    open.inBin.value = false;
  };
  return (
    <WayBack
      words={words.inBin}
      action={words.takeBack}
      testId="take-back"
      onBack={takeBack}
      onClose={() => {
        closed.value = true;
      }}
    />
  );
}
