// The page of a report: what it is says its data.

const report = JSON.parse(document.getElementById("report").textContent);
const pages = { audit: audit_page, cost: cost_page, ladder: ladder_page };
const main = document.getElementById("page");
main.replaceChildren();
pages[report.report](report, (...parts) => main.append(...parts.filter(Boolean)));
window.rayaudit.interactive = performance.now();
