import { texts } from "../i18n";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import type { ParametersOf } from "../shell/route";
import { loadPresented } from "./load";
import { Presentation } from "./Presentation";

/** One run, or two side by side, for the projector. */
export function PresentationScreen(route: ParametersOf<"presentation">) {
  const { first, second } = route;
  const loaded = useLoaded(`${first} ${second}`, () => loadPresented(first, second), {
    release: ({ playback }) => playback.dispose(),
  });
  return (
    <Loaded of={loaded} as="screen" loading={texts.value.replay.loading}>
      {(presented) => <Presentation presented={presented} route={route} />}
    </Loaded>
  );
}
