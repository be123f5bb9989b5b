import { useSignal } from "@preact/signals";
import { ChevronDown, ChevronUp, RotateCcw, Trash2 } from "lucide-preact";
import type { Program } from "../api/model";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { when } from "../i18n/format";
import type { ProgramShelf } from "./program_shelf";

/** Programs that were thrown away, at the end of the group's work; nothing while there are none. */
export function Bin({ shelf }: { shelf: ProgramShelf }) {
  const open = useSignal(false);
  const { keeping } = texts.value;
  const { value: bin } = shelf.bin;
  if (bin.length === 0) return null;
  const Chevron = open.value ? ChevronUp : ChevronDown;
  return (
    <section class="bin">
      <button
        type="button"
        class="button"
        data-testid={TEST.bin}
        aria-expanded={open.value}
        onClick={() => {
          open.value = !open.value;
        }}
      >
        <Trash2 class="icon" aria-hidden="true" />
        {keeping.bin(bin.length)}
        <Chevron class="icon" aria-hidden="true" />
      </button>
      {open.value && (
        <>
          <p class="bin__hint">{keeping.binHint}</p>
          <ul class="bin__programs">
            {bin.map((program) => (
              <Thrown key={program.id} program={program} shelf={shelf} />
            ))}
          </ul>
        </>
      )}
    </section>
  );
}

function Thrown({ program, shelf }: { program: Program; shelf: ProgramShelf }) {
  const { keeping, work } = texts.value;
  const changed = when(program.updated_at, new Date(), language.value, texts.value);
  return (
    <li class="bin__program card" data-testid={TEST.binProgram}>
      <span class="bin__words">
        <strong class="work-card__name">{program.name}</strong>
        <span class="bin__line">
          {work.changed(changed)} · {work.runCount(program.n_runs)}
        </span>
      </span>
      <button
        type="button"
        class="button"
        data-testid={TEST.takeBack}
        aria-label={`${keeping.takeBack}: ${program.name}`}
        onClick={() => void shelf.takeBack(program).catch(report)}
      >
        <RotateCcw class="icon" aria-hidden="true" />
        {keeping.takeBack}
      </button>
    </li>
  );
}
