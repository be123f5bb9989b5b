import { matchesAll, tokenize } from "../../blocks/toolbox/search";
import { texts } from "../../i18n";
import { keyGroups } from "./keys";

/** The keys; with a query, only the keys whose description matches. */
export function KeyList({ query }: { query: string }) {
  const queryTerms = tokenize(query);
  const matches = (text: string) => matchesAll(text, queryTerms);
  const groups = keyGroups(texts.value)
    .map(({ title, rows, more = [] }) => ({
      title,
      rows: rows.filter(({ keys, description }) => matches(`${keys.join(" ")} ${description}`)),
      more: more.filter(matches),
    }))
    .filter(({ rows, more }) => rows.length + more.length > 0);
  return (
    <>
      {groups.map(({ title, rows, more }) => (
        <section key={title} class="help__keys">
          <h2>{title}</h2>
          <dl>
            {rows.map(({ keys, description }) => (
              <div key={description}>
                <dt>
                  {keys.map((key) => (
                    <kbd key={key}>{key}</kbd>
                  ))}
                </dt>
                <dd>{description}</dd>
              </div>
            ))}
          </dl>
          {more.map((line) => (
            <p key={line}>{line}</p>
          ))}
        </section>
      ))}
    </>
  );
}
