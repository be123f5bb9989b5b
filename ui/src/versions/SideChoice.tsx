import { useComputed } from "@preact/signals";
import type { VersionSummary } from "../api/model";
import { language, texts } from "../i18n";
import { Select } from "../kit/Select";
import { go } from "../shell/route";
import type { Compared } from "./differences";
import { faceOf, sectionsOf } from "./line";
import { sectionText, versionLine } from "./version_texts";

interface SideChoiceProps {
  side: "before" | "after";
  compared: Compared;
  programId: string;
}

/** Selects the version of one side: offers the last version of each step, and the selected version. */
export function SideChoice({ side, compared, programId }: SideChoiceProps) {
  const labels = texts.value.archive;
  const shown = compared[side];
  const sections = useComputed(() =>
    sectionsOf(compared.line).map((section) => ({
      label: sectionText(section, new Date(), language.value, texts.value),
      versions: section.items
        .flatMap((item) =>
          item.kind === "step" ? [item] : item.branches.flatMap(({ steps }) => steps),
        )
        .flatMap((step): VersionSummary[] => {
          const inner = step.versions.find(({ id }) => id === shown.id);
          const face = faceOf(step);
          return inner && inner !== face ? [inner, face] : [face];
        }),
    })),
  );
  const name = labels[side];
  return (
    <div class="differences__choice row middle rigid gap-3">
      <strong>{name}</strong>
      <Select
        label={labels.choose({ side: name })}
        testId="difference-side"
        data-side={side}
        value={shown.id}
        groups={sections.value.map(({ label: heading, versions }) => [
          heading,
          versions.map((version) => [
            version.id,
            versionLine(version, language.value, texts.value),
          ]),
        ])}
        onChange={(id) => {
          const [before, after] = [compared.before.id, compared.after.id];
          const next = side === "before" ? { before: id, after } : { before, after: id };
          go({ screen: "differences", program: programId, ...next });
        }}
      />
    </div>
  );
}
