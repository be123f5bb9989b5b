import { useSignal } from "@preact/signals";
import { texts } from "../i18n";
import { hashOf } from "../shell/route";
import { manualLanguage } from "./library";
import { ManualHits } from "./ManualHits";
import type { Manual } from "./model";
import { SearchField } from "./SearchField";
import { searchManuals } from "./search";

/** All manuals, each with its sections, and a search in them. */
export function ManualList({ manuals }: { manuals: readonly Manual[] }) {
  const { titles, help } = texts.value;
  const query = useSignal("");
  return (
    <div class="manuals__list column gap-4">
      <div class="row middle gap-4">
        <h1>{titles.manuals}</h1>
        <SearchField query={query} label={help.manuals.search} testId="manuals-search" />
      </div>
      <div class="column gap-3">
        {query.value.trim() ? (
          <Results manuals={manuals} query={query.value} />
        ) : (
          manuals.map((one) => <ManualLink key={one.name} manual={one} />)
        )}
      </div>
    </div>
  );
}

function Results({ manuals, query }: { manuals: readonly Manual[]; query: string }) {
  const hits = searchManuals(manuals, query);
  if (hits.length === 0) return <p role="status">{texts.value.help.nothing}</p>;
  return <ManualHits hits={hits} />;
}

function ManualLink({ manual }: { manual: Manual }) {
  const titles = manual.sections.map(({ title }) => title).filter(Boolean);
  return (
    <a
      class="manuals__one card column gap-1"
      lang={manualLanguage()}
      href={hashOf({ screen: "manuals", manual: manual.name, section: null })}
      data-testid="manual-link"
      data-manual={manual.name}
    >
      <strong>{manual.title}</strong>
      <span class="aside">{titles.join(" · ")}</span>
    </a>
  );
}
