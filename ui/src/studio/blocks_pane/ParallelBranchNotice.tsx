import { useSignal } from "@preact/signals";
import { Columns2 } from "lucide-preact";
import type { ProgramWithVersion } from "../../api/model";
import { texts } from "../../i18n";
import { UndoBanner } from "../../kit/UndoBanner";
import { go } from "../../shell/route";
import { choose, setting } from "../../shell/settings";

const acknowledged = setting("pinel_elsewhere");
const SEPARATOR = "_";
/** Enough ids for all groups of a school, and far below the maximum length of a setting. */
const MAX_IDS = 40;

/** If two PCs have continued one program, shows the group once where the other version is. */
export function ParallelBranchNotice({ program }: { program: ProgramWithVersion }) {
  const { elsewhere, version } = program;
  const isHidden = useSignal(elsewhere === null || acknowledgedIds().includes(elsewhere.id));
  if (isHidden.value || !elsewhere || !version) return null;
  const labels = texts.value.archive;
  const acknowledge = () => {
    void choose(
      "pinel_elsewhere",
      [...acknowledgedIds(), elsewhere.id].slice(-MAX_IDS).join(SEPARATOR),
    );
    isHidden.value = true;
  };
  return (
    <UndoBanner
      text={labels.elsewhere({ computer: elsewhere.computer || labels.unknownComputer })}
      action={labels.compareBranches}
      Icon={Columns2}
      testId="elsewhere"
      onBack={() => {
        acknowledge();
        const [before, after] = [elsewhere.id, version.id];
        go({ screen: "differences", program: program.id, before, after });
      }}
      onClose={acknowledge}
    />
  );
}

const acknowledgedIds = () => acknowledged.peek().split(SEPARATOR).filter(Boolean);
