import { TriangleAlert } from "lucide-preact";
import { live, liveRun } from "../run/live";
import { followedRun } from "../run/real/truth_sources";
import { isLive } from "../run/reducer";

/** While a run is live: why a source of truth does not see the robot now, and what to do. */
export function SourceTrouble() {
  if (!isLive(live.value)) return null;
  const troubled = followedRun(liveRun.value?.id ?? null).value.filter(({ problem }) => problem);
  return (
    <>
      {troubled.map(({ source, problem }) => (
        <p
          key={source}
          class="source-trouble row middle gap-2"
          role="status"
          data-testid="source-trouble"
          data-source={source}
        >
          <TriangleAlert class="icon" aria-hidden="true" />
          {problem}
        </p>
      ))}
    </>
  );
}
