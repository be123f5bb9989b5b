import { versionsApi } from "../api/versions";
import { texts } from "../i18n";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { nameInHeader } from "../shell/named";
import type { ParametersOf } from "../shell/route";
import { couldNotOpen } from "../studio/program/open_program";
import { Differences } from "./Differences";
import type { Compared } from "./differences";

/** Two versions of a program side by side, with the difference of each block. */
export function DifferencesScreen({ program, before, after }: ParametersOf<"differences">) {
  const compared = useLoaded(`${program} ${before} ${after}`, () => load(program, before, after), {
    onFailed: couldNotOpen,
  });
  return (
    <Loaded of={compared} as="screen" loading={texts.value.archive.loading}>
      {(loaded) => <Differences compared={loaded} programId={program} />}
    </Loaded>
  );
}

async function load(programId: string, before: string, after: string): Promise<Compared> {
  const [line, first, second, difference] = await Promise.all([
    versionsApi.line(programId),
    versionsApi.version(before),
    versionsApi.version(after),
    versionsApi.difference(before, after),
    nameInHeader(programId),
  ]);
  return { line, before: first, after: second, difference };
}
