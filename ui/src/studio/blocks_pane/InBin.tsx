import { useSignal } from "@preact/signals";
import { versionsApi } from "../../api/versions";
import { texts } from "../../i18n";
import { UndoBanner } from "../../kit/UndoBanner";
import type { OpenProgram } from "../program/open_program";

/** Reports that this or another window moved the open program to the bin, and offers undo. */
export function InBin({ open }: { open: OpenProgram }) {
  const closed = useSignal(false);
  if (closed.value || !open.inBin.value || open.deleted.value) return null;
  const labels = texts.value.archive;
  const restore = async () => {
    await versionsApi.restore(open.id);
    open.inBin.value = false;
  };
  return (
    <UndoBanner
      text={labels.inBin}
      action={labels.takeBack}
      testId="take-back"
      onBack={restore}
      onClose={() => {
        closed.value = true;
      }}
    />
  );
}
