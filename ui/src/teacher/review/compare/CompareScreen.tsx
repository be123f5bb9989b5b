import { api } from "../../../api/client";
import { texts } from "../../../i18n";
import { Loaded } from "../../../kit/requests/Loaded";
import { useLoaded } from "../../../kit/requests/useLoaded";
import { loadRecording } from "../../../replay/recording";
import { RequireTeacher } from "../../sign_in/RequireTeacher";
import { Compare } from "./Compare";
import { Pair } from "./pair";

interface CompareScreenProps {
  first: string;
  second: string;
}

/** Two runs side by side with a shared playback clock. */
export function CompareScreen(runs: CompareScreenProps) {
  return (
    <RequireTeacher>
      <LoadedPair {...runs} />
    </RequireTeacher>
  );
}

function LoadedPair({ first, second }: CompareScreenProps) {
  const loaded = useLoaded(`${first} ${second}`, () => loadPair(first, second), {
    release: ({ pair }) => pair.dispose(),
  });
  return (
    <Loaded of={loaded} as="screen" loading={texts.value.review.compare.opening}>
      {({ pair, groups }) => <Compare pair={pair} groups={groups} />}
    </Loaded>
  );
}

async function loadPair(first: string, second: string) {
  const [one, other, groups] = await Promise.all([
    loadRecording(first),
    loadRecording(second),
    api.groups(),
  ]);
  return { pair: new Pair(one, other), groups };
}
