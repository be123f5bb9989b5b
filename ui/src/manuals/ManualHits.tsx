import { hashOf } from "../shell/route";
import { manualLanguage } from "./library";
import type { ManualHit } from "./search";

/** Sections of the manuals that were found, as links. */
export function ManualHits({ hits }: { hits: readonly ManualHit[] }) {
  return (
    <ul class="manual-hits" lang={manualLanguage()}>
      {hits.map(({ manual, section, excerpt }) => (
        <li key={`${manual.name} ${section.id}`}>
          <a
            class="manual-hits__one column"
            href={hashOf({ screen: "manuals", manual: manual.name, section: section.id || null })}
            data-testid="manual-hit"
          >
            <strong>{section.title || manual.title}</strong>
            {section.title && <span class="aside">{manual.title}</span>}
            <span class="manual-hits__excerpt">{excerpt}</span>
          </a>
        </li>
      ))}
    </ul>
  );
}
