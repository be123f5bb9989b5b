import { useSignal } from "@preact/signals";
import { FileClock, History } from "lucide-preact";
import { texts } from "../../i18n";
import { UndoBanner } from "../../kit/UndoBanner";
import { go } from "../../shell/route";
import { type OpenProgram, openNewest } from "../program/open_program";

/** Reports that another window has saved a version of the open program. */
export function OtherWindow({ open }: { open: OpenProgram }) {
  const closed = useSignal(false);
  const { other, isStale } = open.windows;
  const { value: version } = other;
  if (closed.value || version === null || open.deleted.value) return null;
  const labels = texts.value.archive;
  const toNewest = isStale.value;
  return (
    <UndoBanner
      text={labels.otherWindow}
      action={toNewest ? labels.openNewest : labels.seeOther}
      Icon={toNewest ? FileClock : History}
      testId="other-window"
      onBack={() =>
        toNewest ? openNewest(open) : go({ screen: "versions", program: open.id, version })
      }
      onClose={() => {
        closed.value = true;
      }}
    />
  );
}
