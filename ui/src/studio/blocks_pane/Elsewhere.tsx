import { useSignal } from "@preact/signals";
import { Columns2 } from "lucide-preact";
import type { ProgramWithVersion } from "../../api/model";
import { texts } from "../../i18n";
import { WayBack } from "../../kit/WayBack";
import { go } from "../../shell/route";
import { choose, setting } from "../../shell/settings";

const told = setting("pinel_elsewhere");
const APART = "_";
/** Enough for all groups of a school, and far below what a setting may hold. */
const MOST_KEPT = 40;

/** Two PCs have continued one program: tells the group once where the other version is. */
export function Elsewhere({ program }: { program: ProgramWithVersion }) {
  const { elsewhere, version } = program;
  const isSeen = useSignal(elsewhere === null || seen().includes(elsewhere.id));
  if (isSeen.value || !elsewhere || !version) return null;
  const words = texts.value.keeping;
  const see = () => {
    void choose("pinel_elsewhere", [...seen(), elsewhere.id].slice(-MOST_KEPT).join(APART));
    isSeen.value = true;
  };
  return (
    <WayBack
      words={words.elsewhere(elsewhere.computer || words.unknownComputer)}
      action={words.compareBranches}
      Icon={Columns2}
      testId="elsewhere"
      onBack={() => {
        see();
        const [before, after] = [elsewhere.id, version.id];
        go({ screen: "differences", program: program.id, before, after });
      }}
      onClose={see}
    />
  );
}

const seen = () => told.peek().split(APART).filter(Boolean);
