import { texts } from "../i18n";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import type { ParametersOf } from "../shell/route";
import { PresentedProgram } from "./PresentedProgram";
import { loadProgram } from "./program";

/** The blocks of a program, for the projector. */
export function PresentedProgramScreen(route: ParametersOf<"presentedprogram">) {
  const loaded = useLoaded(route.program, () => loadProgram(route.program));
  return (
    <Loaded of={loaded} as="screen" loading={texts.value.replay.loading}>
      {(program) => <PresentedProgram program={program} route={route} />}
    </Loaded>
  );
}
