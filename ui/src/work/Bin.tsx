import { useSignal } from "@preact/signals";
import { ChevronDown, ChevronUp, RotateCcw, Trash2 } from "lucide-preact";
import type { Program } from "../api/model";
import { language, texts } from "../i18n";
import { relativeTime } from "../i18n/format";
import { changedText, labelled } from "../i18n/phrases";
import { Button } from "../kit/Button";
import type { ProgramCollection } from "./program_collection";

/** The programs in the bin; renders nothing while it is empty. */
export function Bin({ collection }: { collection: ProgramCollection }) {
  const open = useSignal(false);
  const { archive } = texts.value;
  const { value: bin } = collection.bin;
  if (bin.length === 0) return null;
  return (
    <section>
      <Button
        icon={Trash2}
        iconEnd={open.value ? ChevronUp : ChevronDown}
        testId="bin"
        open={open.value}
        onPress={() => {
          open.value = !open.value;
        }}
      >
        {archive.bin({ n: bin.length })}
      </Button>
      {open.value && (
        <>
          <p class="bin__hint">{archive.binHint}</p>
          <ul class="bin__programs">
            {bin.map((program) => (
              <Thrown key={program.id} program={program} collection={collection} />
            ))}
          </ul>
        </>
      )}
    </section>
  );
}

function Thrown({ program, collection }: { program: Program; collection: ProgramCollection }) {
  const { archive, work } = texts.value;
  const changed = relativeTime(program.updated_at, new Date(), language.value, texts.value);
  return (
    <li class="bin__program card row middle gap-3" data-testid="bin-program">
      <span class="grid grows shrinks">
        <strong class="work-card__name">{program.name}</strong>
        <span class="bin__line">
          {changedText(changed, texts.value)} · {work.runCount({ count: program.n_runs })}
        </span>
      </span>
      <Button
        icon={RotateCcw}
        label={labelled(archive.takeBack, program.name)}
        testId="take-back"
        onPress={() => collection.restore(program)}
      >
        {archive.takeBack}
      </Button>
    </li>
  );
}
