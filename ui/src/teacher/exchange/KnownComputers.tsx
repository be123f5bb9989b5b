import type { HeardComputer } from "../api/exchange";
import { language, texts } from "../i18n";
import { when } from "../i18n/format";
import { words } from "./words";

/** PCs whose work is here, and when it came. */
export function Heard({ computers }: { computers: readonly HeardComputer[] }) {
  const say = words.value;
  const now = new Date();
  const at = (iso: string) => when(iso, now, language.value, texts.value);
  return (
    <section class="exchange__box" aria-labelledby="exchange-heard">
      <h2 id="exchange-heard">{say.heard}</h2>
      {computers.length === 0 ? (
        <p class="exchange__none">{say.heardNobody}</p>
      ) : (
        <>
          <table class="exchange__table">
            <thead>
              <tr>
                <th scope="col">{say.computer}</th>
                <th scope="col">{say.exported}</th>
                <th scope="col">{say.merged}</th>
                <th scope="col" class="exchange__number">
                  {say.heardRuns}
                </th>
              </tr>
            </thead>
            <tbody>
              {computers.map((one) => (
                <tr key={one.computer_id}>
                  <th scope="row">{one.name}</th>
                  <td>{at(one.exported_at)}</td>
                  <td>{at(one.merged_at)}</td>
                  <td class="exchange__number">{one.n_runs}</td>
                </tr>
              ))}
            </tbody>
          </table>
          <p class="exchange__none">{say.clock}</p>
        </>
      )}
    </section>
  );
}
