// PRIVATE STAND-IN, NOT COMMITTED
#include "core/render/render_thread.h"
#include "core/compute/device.h"
#include "core/scene/camera_motion.h"
#include "ui/document/document.h"
#include <condition_variable>
#include <mutex>
#include <thread>
#include <deque>
#include <chrono>
#include <cmath>
using namespace std::chrono_literals;
namespace prizma {
std::vector<DeviceInfo> listDevices() {
    DeviceInfo a; a.id="P / cpu"; a.platform="Portable Computing Language"; a.name="pthread-Intel(R) Xeon(R) Platinum 8488C"; a.vendor="GenuineIntel"; a.driverVersion="3.1"; a.openclVersion="OpenCL 3.0"; a.type=DeviceType::Cpu; a.computeUnits=2; a.clockMHz=2400; a.globalMemory=8ull<<30; a.maxAllocation=2ull<<30; a.localMemory=512<<10; a.maxWorkGroupSize=4096; a.floatVectorWidth=16; a.doublePrecision=true; a.usable=true;
    DeviceInfo b=a; b.id="N / H200"; b.platform="NVIDIA CUDA"; b.name="NVIDIA H200"; b.type=DeviceType::Gpu; b.computeUnits=132; b.globalMemory=139ull<<30;
    DeviceInfo c=a; c.id="X / broken"; c.name="Broken accelerator"; c.platform="Other"; c.usable=false; c.type=DeviceType::Accelerator; c.doublePrecision=false;
    if (getenv("STANDIN_NO_DEVICE")) return {};
    return {a,b,c};
}
int chooseDevice(const std::vector<DeviceInfo>& d, const std::string& p){ for(size_t i=0;i<d.size();++i) if(d[i].id==p) return int(i); return d.empty()?-1:0; }
std::string describe(DeviceType t){ switch(t){case DeviceType::Cpu:return "CPU";case DeviceType::Gpu:return "GPU";case DeviceType::Accelerator:return "Accelerator";default:return "Other";} }
class RenderThread::Worker {
 public:
  RenderEvents e; std::mutex m; std::condition_variable cv; bool quit=false; bool fresh=false; RenderRequest req; std::deque<std::function<void()>> jobs; DeviceInfo dev; std::thread th; int samples=0;
  Worker(RenderEvents ev,std::string id):e(std::move(ev)),th([this,id]{run(id);}){}
  ~Worker(){ {std::scoped_lock l(m); quit=true;} cv.notify_all(); th.join(); }
  void select(const std::string& id, bool first){ auto d=listDevices(); int i=-1; for(size_t k=0;k<d.size();++k) if(d[k].id==id&&d[k].usable) i=int(k); if(first&&i<0) i=chooseDevice(d,id); if(i<0){ e.message(failure("There is no OpenCL device \""+id+"\".").error()); return;} dev=d[size_t(i)]; e.activity("Building kernels",true); std::this_thread::sleep_for(50ms); e.activity("Building kernels",false); e.deviceChanged(dev); fresh=true; }
  static double hitSphere(const Camera& c, glm::dvec2 p){ auto d=glm::normalize(pointInPicture(c,p,1.0)-c.position); double q=-c.position.z/d.z; auto h=c.position+q*d; return q>0&&std::abs(h.x)<=1&&std::abs(h.y)<=1?q:-1; }
  void run(std::string id){ select(id,true); std::unique_lock l(m); for(;;){ cv.wait_for(l, 1h, [&]{return quit||fresh||!jobs.empty()||(samples>0&&samples<req.scene.render.samples);}); if(quit) return; if(!jobs.empty()){auto j=jobs.front(); jobs.pop_front(); l.unlock(); j(); l.lock(); continue;} if(dev.id.empty()||req.width==0){fresh=false;samples=0;continue;} if(fresh){fresh=false;samples=0;} if(req.paused){samples=0;continue;} auto r=req; l.unlock();
     auto f=std::make_shared<Frame>(); int s=r.interacting?2:1; f->width=std::max(1,r.width/s); f->height=std::max(1,r.height/s); f->pixels.resize(size_t(f->width)*size_t(f->height)*4); ++samples; 
     for(int y=0;y<f->height;++y)for(int x=0;x<f->width;++x){ glm::dvec2 p((2.0*(x+.5)-f->width)/f->height,1-2.0*(y+.5)/f->height); double t=hitSphere(r.scene.camera,p); auto*px=&f->pixels[size_t(y*f->width+x)*4]; auto d=glm::normalize(pointInPicture(r.scene.camera,p,1.0)-r.scene.camera.position); if(t>0){auto n=r.scene.camera.position+d*t; for(int k=0;k<3;++k)px[k]=uint8_t(127+127*n[k]);} else {px[0]=uint8_t(100+100*d.x);px[1]=uint8_t(100+100*d.y);px[2]=uint8_t(128);} px[3]=255; }
     std::this_thread::sleep_for(15ms); f->samples=samples; f->sampleLimit=r.scene.render.samples; f->isFinal=samples>=r.scene.render.samples&&!r.interacting; f->camera=r.scene.camera; f->statistics.device=dev.name; f->statistics.stages={{"GenerateCameraRays","camera moved",0.8,0},{"Top level","bunny moved",0.4,3},{"RayShader","camera moved",11.25,0}}; f->statistics.rays={921600,1500000,300000}; f->statistics.passMilliseconds=14.2; f->statistics.triangles=816342; f->statistics.deviceBytes=123456789; e.frame(f); l.lock(); } }
};
RenderThread::RenderThread(RenderEvents e,std::string id):worker_(std::make_unique<Worker>(std::move(e),id)){}
RenderThread::~RenderThread()=default;
void RenderThread::submit(RenderRequest r){ {std::scoped_lock l(worker_->m); worker_->req=std::move(r); worker_->fresh=true;} worker_->cv.notify_all(); }
void RenderThread::selectDevice(std::string id){ {std::scoped_lock l(worker_->m); worker_->jobs.push_back([this,id]{worker_->select(id,false);});} worker_->cv.notify_all(); }
void RenderThread::pick(double x,double y,std::function<void(Pick)> a){ {std::scoped_lock l(worker_->m); auto r=worker_->req; worker_->jobs.push_back([=]{ glm::dvec2 p((2*x-r.width)/r.height,1-2*y/r.height); double t=Worker::hitSphere(r.scene.camera,p); Pick k; if(t>0&&!r.scene.objects.empty()){k.object=r.scene.objects[0].id; k.position=r.scene.camera.position+t*glm::normalize(pointInPicture(r.scene.camera,p,1.0)-r.scene.camera.position);} a(k);});} worker_->cv.notify_all(); }
Document::Document(QObject* p):QObject(p){}
void Document::setSelection(std::vector<EntityRef> s){ if(s==selection_) return; selection_=std::move(s); Q_EMIT selectionChanged(); }
void Document::edit(const QString&, const std::function<void(Scene&)>& c, int){ Scene s=scene_; c(s); apply(s); }
void Document::setCamera(const Camera& c){ Scene s=scene_; s.camera=c; apply(s); }
void Document::reset(Scene s,const QString& f,UnknownKeysPtr){ file_=f; apply(s); }
void Document::apply(const Scene& s){ const auto d=diff(scene_,s); scene_=s; if(!d.isEmpty()) Q_EMIT sceneChanged(d); }
bool Document::isModified() const { return cameraMoved_; }
}
