import { texts } from "../../i18n";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import type { ParametersOf } from "../../shell/route";
import { RequireTeacher } from "../../teacher/sign_in/RequireTeacher";
import { Compare } from "./Compare";
import { loadPair } from "./load_pair";

/** Two runs side by side with a shared playback clock. */
export function CompareScreen(runs: ParametersOf<"compare">) {
  return (
    <RequireTeacher>
      <LoadedPair {...runs} />
    </RequireTeacher>
  );
}

function LoadedPair({ first, second }: ParametersOf<"compare">) {
  const loaded = useLoaded(`${first} ${second}`, () => loadPair(first, second), {
    release: ({ pair, blocks }) => {
      pair.dispose();
      blocks?.dispose();
    },
  });
  return (
    <Loaded of={loaded} as="screen" loading={texts.value.review.compare.opening}>
      {(ready) => <Compare {...ready} />}
    </Loaded>
  );
}
