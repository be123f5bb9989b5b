import { useComputed } from "@preact/signals";
import { ChevronDown } from "lucide-preact";
import type { VersionMark } from "../api/keeping";
import { go } from "../app/route";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import type { Compared } from "./DifferencesScreen";
import { faceOf, sectionsOf } from "./line";
import { sectionWords, versionLine } from "./words";

interface SideChoiceProps {
  side: "before" | "after";
  compared: Compared;
  programId: string;
}

/** Which version stands on a side: what each step of the line led to, and the one that is shown. */
export function SideChoice({ side, compared, programId }: SideChoiceProps) {
  const words = texts.value.keeping;
  const shown = compared[side];
  const sections = useComputed(() =>
    sectionsOf(compared.line).map((section) => ({
      words: sectionWords(section, new Date(), language.value, texts.value),
      versions: section.items
        .flatMap((item) =>
          item.kind === "step" ? [item] : item.branches.flatMap(({ steps }) => steps),
        )
        .flatMap((step): VersionMark[] => {
          const inner = step.versions.find(({ id }) => id === shown.id);
          const face = faceOf(step);
          return inner && inner !== face ? [inner, face] : [face];
        }),
    })),
  );
  const name = words[side];
  return (
    <div class="differences__choice">
      <strong>{name}</strong>
      <span class="select">
        <select
          aria-label={words.choose(name)}
          data-testid={TEST.differenceSide}
          data-side={side}
          value={shown.id}
          onChange={({ currentTarget: { value } }) => {
            const [before, after] = [compared.before.id, compared.after.id];
            const next = side === "before" ? { before: value, after } : { before, after: value };
            go({ screen: "differences", program: programId, ...next });
          }}
        >
          {sections.value.map((section) => (
            <optgroup key={section.words} label={section.words}>
              {section.versions.map((version) => (
                <option key={version.id} value={version.id}>
                  {versionLine(version, language.value, texts.value)}
                </option>
              ))}
            </optgroup>
          ))}
        </select>
        <ChevronDown class="icon icon--end" aria-hidden="true" />
      </span>
    </div>
  );
}
